#pragma once

#include "collision/bounding_sphere.h"

#include <glm/vec3.hpp>
#include <span>

namespace collision {

/// Computes the smallest sphere around points: the alternative to the lab's average_sphere.
/// Every point is inside: the radius is rounded up to a float. It is at most that much, and 1e-10 of itself,
/// larger than the smallest. Duplicates and points on a line, plane or sphere are as good as any others.
/// No points: the empty sphere. One point, or all at one place: radius 0. Precondition: all are finite.
/// The time is that of looking through the points about ten times. The same points in another order give the
/// same sphere but for rounding.
BoundingSphere smallest_sphere(std::span<const glm::vec3> points);

/// Computes the smallest sphere around spheres. Each is inside, in exact arithmetic; the radius is at most
/// 1e-10 of itself larger than the smallest, and what rounding its centre costs. Empty ones do not count;
/// none: the empty sphere. Precondition: all are finite, none reaches beyond 1e100 m.
BoundingSphere smallest_enclosing(std::span<const BoundingSphere> spheres);

} // namespace collision
