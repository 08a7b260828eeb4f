#pragma once

#include "tank/part.h"

#include <cstdint>

namespace scene {

/// A colour as glColor3ub takes it.
struct Rgb
{
    std::uint8_t red;
    std::uint8_t green;
    std::uint8_t blue;
};

/// Returns the one colour of a mesh of the low-detail tank, which is neither lit nor textured.
Rgb low_colour(tank::MeshKind mesh);

} // namespace scene
