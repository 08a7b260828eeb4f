#pragma once

#include "mesh/obj_mesh.h"
#include "tank/part.h"

#include <array>

namespace scene {

/// The display lists of the tank's five meshes. They belong to the context that was current when they were
/// compiled, and go with it.
class TankLists
{
public:
    /// Compiles each mesh into a display list of its own, in the order of tank::MeshKind.
    /// Called again, it replaces the lists. Returns false when OpenGL has no names for lists left.
    bool load_tank_objs(const std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT>& objs);

    /// Returns the name of a mesh's display list; 0 before load_tank_objs.
    unsigned list(tank::MeshKind mesh) const;

private:
    unsigned first_list_ = 0;
};

} // namespace scene
