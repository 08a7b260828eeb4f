#pragma once

#include "mesh/image.h"
#include "tests/mesh/invariants.h"
#include "tests/mesh/sample_files.h"

#include <gtest/gtest.h>
#include <utility>

/// Reads an image that has to be one.
inline mesh::Image read(const Bytes& bytes)
{
    mesh::Result<mesh::Image> result = mesh::read_image("test.png", bytes);
    EXPECT_TRUE(result) << (result ? "" : result.error().message());
    if (!result)
        return {};
    EXPECT_EQ(broken_invariant(result.value()), "");
    return std::move(result).value();
}
