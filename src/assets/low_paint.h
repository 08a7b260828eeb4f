#pragma once

#include "image/image.h"
#include "mesh/obj_mesh.h"
#include "tank/part.h"

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace assets {

/// Holds the paint of a face's three corners: red, green and blue in [0, 1], as a texture would have them,
/// without light.
using FacePaint = std::array<glm::vec3, 3>;

/// Holds the paint of each face of the five low meshes, by index of mesh and face.
using LowPaint = std::array<std::vector<FacePaint>, tank::MESH_KIND_COUNT>;

/// Says from where the low tank is seen where it takes the place of the high one.
struct PaintView
{
    double field_of_view; ///< radians, from the bottom to the top of the window
    double distance;      ///< metres, from the eye
};

/// Returns the paint of each face of a low mesh: fitted at its corners (corner_fit.h) to what the texture
/// shows on the high mesh where that lies nearest to the face and looks the same way; and shows in
/// `view`, where neighbours in the texture have become one. A face to which nothing is nearest
/// gets the mean of the whole mesh; so do all faces of a low mesh of more than a thousand. Lengths in metres.
/// Both meshes in one frame, as the lab's are, wound as their normals say. Preconditions: the image has as
/// many pixels as its size says, at least one; corners index what is there.
std::vector<FacePaint> paint_of(const mesh::ObjMesh& low, const mesh::ObjMesh& high,
                                const image::Image& texture, const PaintView& view);

} // namespace assets
