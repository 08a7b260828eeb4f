#pragma once

#include "collision/triangle.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace collision {

/// Holds the point of a mesh that is closest to another point.
struct NearestTriangle
{
    std::size_t triangle; ///< the first of those equally near
    glm::dvec3 point;
    double distance; ///< metres
};

/// Returns the point of the mesh's surface closest to p; nothing for no triangles or a p that is not finite.
std::optional<NearestTriangle> nearest_triangle(const glm::dvec3& p, std::span<const Triangle> triangles);

/// Returns how often the mesh winds around p, anticlockwise being outside: 1 inside a closed mesh and 0
/// outside, 2 where two shells overlap, something between where the mesh has a hole; -1 inside a mesh turned
/// inside out. On the surface itself it is anything between. Not-a-number for a p that is not finite.
/// The triangles' solid angles: Van Oosterom and Strackee (1983); of open meshes: Jacobson, Kavan,
/// Sorkine-Hornung, Robust Inside-Outside Segmentation using Generalized Winding Numbers (2013).
double winding_number(const glm::dvec3& p, std::span<const Triangle> triangles);

/// Returns whether p is in the solid that the mesh encloses: it winds around p by half a turn or more, either
/// way. Right for closed meshes and overlapping shells; and, away from them, despite small holes and a few
/// triangles that wind the wrong way, as files by hand have them. False for a p that is not finite.
bool is_point_inside_mesh(const glm::dvec3& p, std::span<const Triangle> triangles);

} // namespace collision
