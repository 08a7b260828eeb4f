#pragma once

#include "mesh/image.h"
#include "mesh/obj_mesh.h"
#include "tank/part.h"

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace app {

/// Holds the paint of each face of the five low meshes, by index of mesh and face: red, green and blue in
/// [0, 1], as a texture would have them, without light.
using LowPaint = std::array<std::vector<glm::vec3>, tank::MESH_KIND_COUNT>;

/// Returns the paint of each face of a low mesh: the mean of what the texture shows on the high mesh where
/// that lies nearest to the face and looks the same way. A face to which nothing is nearest gets the mean of
/// the whole mesh; so do all faces of a low mesh of more than a thousand. Lengths in metres. Both meshes in
/// one frame, as the lab's are, wound as their normals say. Preconditions: the image has as many pixels as
/// its size says, at least one; corners index what is there.
std::vector<glm::vec3> paint_of(const mesh::ObjMesh& low, const mesh::ObjMesh& high,
                                const mesh::Image& texture);

} // namespace app
