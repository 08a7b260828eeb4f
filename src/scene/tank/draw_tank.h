#pragma once

#include "collision/part_set.h"
#include "scene/tank/tank_lists.h"
#include "tank/joint.h"
#include "tank/layout.h"
#include "tank/part.h"

namespace scene {

/// A tank as it is drawn: its parts' lists, where the parts hang, how far each joint is turned, and which
/// parts are drawn, by index; what is not drawn carries its children all the same.
/// Only looks at what it is made of, which must outlive it.
class TankDrawing
{
public:
    TankDrawing(const TankLists& lists, const tank::Layout& layout, const tank::JointAngles& joints,
                collision::PartSet parts)
        : lists_(lists), layout_(layout), joints_(joints), parts_(parts)
    {}

    /// Draws the tank with its body's pivot at (x, y, z), metres in the current modelview frame.
    /// Walks the tree of parts on the matrix stack, which is afterwards as it was. The links of the tracks,
    /// if the body has some, are where the wheels of their side have turned them.
    void draw_tank(float x, float y, float z) const;

    /// Draws the low-detail tank in the same way, without light and texture: its lists have the colours that
    /// the sun gives it there.
    /// Call it where draw_tank is called, with GL_LIGHTING and GL_TEXTURE_2D on: they are on again
    /// afterwards, and the current colour is white.
    void draw_tank_low(float x, float y, float z) const;

    /// Draws the tank's shapes in the same way, in the current colour: for its shadow.
    void draw_tank_shape(float x, float y, float z) const;

private:
    void draw_links(assets::Side side, tank::Joint wheels) const;
    template <class DrawMesh> void draw_at(float x, float y, float z, const DrawMesh& draw_mesh) const;
    template <class DrawMesh> void draw_part(tank::Part part, double yaw, const DrawMesh& draw_mesh) const;

    const TankLists& lists_;
    const tank::Layout& layout_;
    const tank::JointAngles& joints_;
    collision::PartSet parts_;
};

} // namespace scene
