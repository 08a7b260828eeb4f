#include "scene/draw_tank.h"

#include "scene/degrees.h"

#include <GL/gl.h>

namespace scene {

void TankDrawing::draw_tank(float x, float y, float z) const
{
    glPushMatrix();
    glTranslatef(x, y, z);
    draw_part(tank::Part::body);
    glPopMatrix();
}

void TankDrawing::draw_part(tank::Part part) const
{
    const tank::PartPlacement& placement = layout_[part];
    glPushMatrix();
    glTranslatef(placement.pivot.x, placement.pivot.y, placement.pivot.z);
    glRotatef(degrees(joints_[placement.joint]), placement.axis.x, placement.axis.y, placement.axis.z);

    // The mesh lies in the joint's frame with a turn and a shift of its own, which no child inherits.
    glPushMatrix();
    glRotatef(degrees(placement.mesh_yaw), 0.0f, 1.0f, 0.0f);
    glTranslatef(placement.mesh_offset.x, placement.mesh_offset.y, placement.mesh_offset.z);
    glCallList(lists_.list(placement.mesh));
    glPopMatrix();

    tank::for_each_child(layout_, part, [this](tank::Part child) { draw_part(child); });
    glPopMatrix();
}

} // namespace scene
