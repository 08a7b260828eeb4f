#pragma once

#include "collision/bounding_sphere.h"

#include <array>
#include <span>

namespace collision {

/// Holds up to two centres.
struct Centres
{
    std::array<glm::dvec3, 2> centres;
    int count = 0;
};

/// Finds the centres of the spheres that touch each of one to four spheres from outside all of them, that
/// is, have them inside and tangent, with the centre in the point, line, plane or space through the given
/// centres. The smallest sphere around any set of spheres is such a one for at most four of them.
/// None where there is none, or the given centres are on one point, line or plane too few.
/// Fischer and Gaertner, The Smallest Enclosing Ball of Balls (2003), section 3.
Centres tangent_sphere_centres(std::span<const BoundingSphere> spheres);

} // namespace collision
