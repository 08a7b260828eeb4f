#pragma once

#include "mesh/obj_mesh.h"

#include <span>

namespace mesh {

/// Which faces of a mesh one polygon of the file was cut into, and how it is shaded.
struct Polygon
{
    int first_face = 0;
    int face_count = 0;
    int smoothing_group = 0; ///< `s` of the file; 0: flat
};

/// Tells whether GL_NORMALIZE can bring `normal` to length 1 in float: its squared length neither vanishes
/// nor overflows.
bool is_normalisable(const glm::vec3& normal);

/// Gives every corner without a normal one of length 1, appended to `mesh.normals`.
/// - In a polygon without a smoothing group: the polygon's normal, the direction of its vector area.
/// - In a smoothing group: at each position, the mean of the normals of the group's triangles that meet
/// there, weighted
///   by their angles, so that how a polygon was cut does not matter (Thuermer, Wuethrich 1998).
/// - A corner whose own normal is not normalisable gets the polygon's, whatever the group.
/// - Where that mean vanishes: the triangle's own normal. Where an area vanishes: +Y.
/// Preconditions: `polygons` cover the faces; positions are finite; indices are within their arrays or -1.
void complete_normals(ObjMesh& mesh, std::span<const Polygon> polygons);

} // namespace mesh
