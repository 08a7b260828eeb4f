#pragma once

#include "assets/low_paint.h"
#include "mesh/obj_mesh.h"

#include <glm/vec3.hpp>
#include <span>

namespace scene {

/// Says how a low mesh stands in the light that its list is compiled for.
struct LowPose
{
    double yaw;         ///< radians about +Y, from the world to the mesh
    bool turns_about_x; ///< its colours are those of all its turns about X, on average: a wheel
};

/// Draws a mesh of the low-detail tank: corners whose colours, by glColor3ub, are the paint of their faces
/// times what light_on() their normals. So it looks as if it were lit where lighting is off. paint: of each
/// face, in [0, 1]; faces beyond its end are white. Meant to be compiled into a display list.
void draw_low_obj(const mesh::ObjMesh& obj, std::span<const assets::FacePaint> paint, const LowPose& pose);

} // namespace scene
