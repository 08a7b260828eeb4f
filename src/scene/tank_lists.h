#pragma once

#include "mesh/obj_mesh.h"
#include "tank/part.h"

#include <array>

namespace scene {

/// The display lists of the tank's five meshes, and those of the five low-detail ones. They belong to the
/// context that was current when they were compiled, and go with it.
class TankLists
{
public:
    using Meshes = std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT>;

    /// Compiles each mesh into a display list of its own, in the order of tank::MeshKind.
    /// Called again, it replaces the lists. Returns false when OpenGL has no names for lists left.
    bool load_tank_objs(const Meshes& objs) { return load(objs, first_list_); }

    /// Does the same with the meshes of the low-detail tank, into lists of their own.
    bool load_low_detail_tank_objs(const Meshes& objs) { return load(objs, first_low_list_); }

    /// Returns the name of a mesh's display list; 0 before load_tank_objs.
    unsigned list(tank::MeshKind mesh) const { return list_after(first_list_, mesh); }

    /// Returns that of the low-detail mesh; 0 before load_low_detail_tank_objs.
    unsigned low_list(tank::MeshKind mesh) const { return list_after(first_low_list_, mesh); }

private:
    static bool load(const Meshes& objs, unsigned& first_list);
    static unsigned list_after(unsigned first_list, tank::MeshKind mesh)
    {
        return first_list == 0 ? 0 : first_list + static_cast<unsigned>(tank::index_of(mesh));
    }

    unsigned first_list_ = 0;
    unsigned first_low_list_ = 0;
};

} // namespace scene
