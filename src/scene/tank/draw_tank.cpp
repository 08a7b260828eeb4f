#include "scene/tank/draw_tank.h"

#include "scene/drawing/degrees.h"
#include "scene/drawing/scoped_state.h"

#include <GL/gl.h>

namespace scene {

void TankDrawing::draw_tank(float x, float y, float z) const
{
    draw_at(x, y, z, [this](tank::MeshKind mesh, double) {
        glCallList(lists_.list(mesh));
        if (mesh == tank::MeshKind::body) {
            draw_links(assets::Side::left, tank::Joint::wheels_left);
            draw_links(assets::Side::right, tank::Joint::wheels_right);
        }
    });
}

void TankDrawing::draw_links(assets::Side side, tank::Joint wheels) const
{
    if (const unsigned list = lists_.track_list(side, joints_[wheels]); list != 0) {
        glCallList(list);
    }
}

void TankDrawing::draw_tank_low(float x, float y, float z) const
{
    const Disabled lighting(GL_LIGHTING);
    const Disabled texture(GL_TEXTURE_2D);
    draw_at(x, y, z, [this](tank::MeshKind mesh, double yaw) { glCallList(lists_.low_list(mesh, yaw)); });
    glColor3ub(255, 255, 255);
}

void TankDrawing::draw_tank_shape(float x, float y, float z) const
{
    draw_at(x, y, z, [this](tank::MeshKind mesh, double) { glCallList(lists_.shape_list(mesh)); });
}

template <class DrawMesh>
void TankDrawing::draw_at(float x, float y, float z, const DrawMesh& draw_mesh) const
{
    glPushMatrix();
    glTranslatef(x, y, z);
    draw_part(tank::Part::body, 0.0, draw_mesh);
    glPopMatrix();
}

/// yaw: by which the joints above turn the part about +Y, radians; draw_mesh is told the mesh's. Joints about
/// other axes are left out of it: guns are raised but little, and a wheel looks the same all round.
template <class DrawMesh>
void TankDrawing::draw_part(tank::Part part, double yaw, const DrawMesh& draw_mesh) const
{
    const tank::PartPlacement& placement = layout_[part];
    yaw += static_cast<double>(placement.axis.y) * joints_[placement.joint];
    glPushMatrix();
    glTranslatef(placement.pivot.x, placement.pivot.y, placement.pivot.z);
    glRotatef(degrees(joints_[placement.joint]), placement.axis.x, placement.axis.y, placement.axis.z);
    if (const std::optional<tank::Turn>& second = placement.second) {
        glTranslatef(second->pivot.x, second->pivot.y, second->pivot.z);
        glRotatef(degrees(joints_[second->joint]), second->axis.x, second->axis.y, second->axis.z);
    }

    if (parts_.contains(tank::index_of(part))) {
        // The mesh lies in the joint's frame with a turn and a shift of its own, which no child inherits.
        glPushMatrix();
        glRotatef(degrees(placement.mesh_yaw), 0.0f, 1.0f, 0.0f);
        glTranslatef(placement.mesh_offset.x, placement.mesh_offset.y, placement.mesh_offset.z);
        draw_mesh(placement.mesh, yaw + placement.mesh_yaw);
        glPopMatrix();
    }

    tank::for_each_child(layout_, part, [&](tank::Part child) { draw_part(child, yaw, draw_mesh); });
    glPopMatrix();
}

} // namespace scene
