#include "scene/tank_lists.h"

#include "scene/draw_obj.h"

#include <GL/gl.h>

namespace scene {
namespace {

constexpr GLsizei LIST_COUNT = tank::MESH_KIND_COUNT;

} // namespace

bool TankLists::load_tank_objs(const std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT>& objs)
{
    if (first_list_ != 0) {
        glDeleteLists(first_list_, LIST_COUNT);
    }
    first_list_ = glGenLists(LIST_COUNT);
    if (first_list_ == 0) {
        return false;
    }
    for (unsigned i = 0; i < objs.size(); ++i) {
        glNewList(first_list_ + i, GL_COMPILE);
        draw_obj(objs[i]);
        glEndList();
    }
    return true;
}

unsigned TankLists::list(tank::MeshKind mesh) const
{
    return first_list_ == 0 ? 0 : first_list_ + static_cast<unsigned>(index_of(mesh));
}

} // namespace scene
