#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace mesh {

/// Three corners of a polygon, as indices into its list of corners.
using CornerTriangle = std::array<int, 3>;

/// Cuts a polygon into its n - 2 triangles and appends them to `triangles`, each in the polygon's direction
/// of turning.
///
/// A polygon whose first corner sees all the others (every convex one) is cut as a fan from there, (0, i, i +
/// 1). Any other is projected along its normal (Newell's) onto the nearest coordinate plane, which loses no
/// precision, and cut by ear clipping. Corners may lie on one line; a polygon may touch itself, as one with a
/// bridge to its hole does. One that has no area, or that crosses itself, is cut into n - 2 triangles all the
/// same, somehow. Preconditions: at least 3 corners, all finite. `steps_left` is lowered by the work done;
/// when it falls below 0, the answer is false and `triangles` is unfinished. The work is about n sqrt(n) at
/// most for polygons as people draw them: corners that could be in an ear's way are found through a grid.
/// Newell: Sutherland, Sproull, Schumacker 1974; ears: Meisters 1975; that testing reflex corners is enough:
/// Eberly, Triangulation by Ear Clipping (2002).
[[nodiscard]] bool triangulate_polygon(std::span<const glm::vec3> corners,
                                       std::vector<CornerTriangle>& triangles, long long& steps_left);

} // namespace mesh
