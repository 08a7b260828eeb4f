#pragma once

#include "mesh/obj_mesh.h"
#include "tank/mesh_box.h"

namespace assets {

/// Returns how high a turret reaches: the highest triangle above or below a place decides. The mesh must
/// outlive what is returned. Triangles on edge have no height anywhere.
tank::TurretRoof roof_of(const mesh::ObjMesh& turret);

} // namespace assets
