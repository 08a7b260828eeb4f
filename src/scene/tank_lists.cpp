#include "scene/tank_lists.h"

#include "scene/draw_obj.h"

#include <GL/gl.h>

namespace scene {
namespace {

constexpr GLsizei LIST_COUNT = tank::MESH_KIND_COUNT;

} // namespace

bool TankLists::load(const Meshes& objs, unsigned& first_list)
{
    if (first_list != 0) {
        glDeleteLists(first_list, LIST_COUNT);
    }
    first_list = glGenLists(LIST_COUNT);
    if (first_list == 0) {
        return false;
    }
    for (unsigned i = 0; i < objs.size(); ++i) {
        glNewList(first_list + i, GL_COMPILE);
        draw_obj(objs[i]);
        glEndList();
    }
    return true;
}

} // namespace scene
