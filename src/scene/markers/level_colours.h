#pragma once

#include "scene/drawing/rgb.h"

namespace scene {

/// Returns the colour of a level of the hierarchy of spheres, in which everything that belongs to it is
/// drawn: the root's, or that of the parts.
constexpr Rgb level_colour(bool is_root)
{
    // Blue and orange are told apart by every eye, on the sky, on the ground and on the tank.
    return is_root ? Rgb{40, 110, 235} : Rgb{245, 95, 20};
}

} // namespace scene
