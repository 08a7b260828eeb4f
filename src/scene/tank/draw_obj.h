#pragma once

#include "mesh/obj_mesh.h"

namespace scene {

/// Draws a mesh corner by corner: the lab's own DrawObj.
/// Each corner takes its position, normal and texture coordinate by three separate indices.
/// A corner without a texture coordinate gets (0, 0), so that no other mesh's coordinate is used for it.
/// Meant to be compiled into a display list.
void draw_obj(const mesh::ObjMesh& obj);

/// Draws a mesh's faces by their positions alone, for its shadow. Wires are left out: faces of more than a
/// metre's length and less than four centimetres' width, such as a whip antenna's. A sun that is no point
/// throws no shadow of those, and the layers of a soft one would throw as many lines. Positions in metres.
void draw_shape(const mesh::ObjMesh& obj);

} // namespace scene
