#pragma once

#include "lod/picture_difference.h"

#include <cstdint>
#include <vector>

namespace lod {

/// Holds a picture of its own.
struct ReducedPicture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    Picture view() const { return {width, height, rgba}; }
};

/// Averages each patch of side x side pixels into one, rounded to nearest, and leaves out what is no whole
/// patch at the right and in the last rows. Preconditions: side >= 1; the picture has as many bytes as its
/// size says.
ReducedPicture reduced(const Picture& picture, int side);

} // namespace lod
