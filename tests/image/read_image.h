#pragma once

#include "image/image.h"
#include "tests/mesh/invariants.h"
#include "tests/mesh/sample_files.h"

#include <gtest/gtest.h>
#include <utility>

/// Reads an image that has to be one.
inline image::Image read(const Bytes& bytes)
{
    base::Result<image::Image> result = image::read_image("test.png", bytes);
    EXPECT_TRUE(result) << (result ? "" : result.error().message());
    if (!result) {
        return {};
    }
    EXPECT_EQ(broken_invariant(result.value()), "");
    return std::move(result).value();
}
