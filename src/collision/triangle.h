#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace collision {

/// A triangle. Metres; any order of corners, unless said otherwise; it may be a line or a point.
struct Triangle
{
    glm::vec3 a;
    glm::vec3 b;
    glm::vec3 c;
};

/// Returns the point of the triangle, edges and corners included, closest to p. In double throughout.
/// A triangle without area is the longest of its edges, or a point.
/// Ericson, Real-Time Collision Detection (2005), 5.1.5 and, for the areas, 3.4.
glm::dvec3 closest_point_on_triangle(const glm::dvec3& p, const Triangle& triangle);

/// Holds where a segment meets a triangle: point = a + parameter * (b - a).
struct SegmentHit
{
    glm::dvec3 point;
    double parameter; ///< along the segment, in [0, 1]
};

/// Returns where segment [a, b] meets the triangle, from either side, edges and corners included; or nothing.
/// Watertight: a segment that goes through a closed surface, even through an edge or a corner, always meets
/// one of the triangles there, and may meet each of those that share it.
/// A segment in the triangle's plane, of no length, or a triangle without area meets nothing.
/// Precondition: all coordinates are finite, their magnitudes below 1e100.
/// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection (2013).
std::optional<SegmentHit> intersect_segment_triangle(const glm::dvec3& a, const glm::dvec3& b,
                                                     const Triangle& triangle);

} // namespace collision
