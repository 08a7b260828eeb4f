#pragma once

#include "scene/tank_lists.h"
#include "tank/joint.h"
#include "tank/layout.h"
#include "tank/part.h"

namespace scene {

/// A tank as it is drawn: its parts' lists, where the parts hang, and how far each joint is turned.
/// Only looks at what it is made of, which must outlive it.
class TankDrawing
{
public:
    TankDrawing(const TankLists& lists, const tank::Layout& layout, const tank::JointAngles& joints)
        : lists_(lists), layout_(layout), joints_(joints)
    {}

    /// Draws the tank with its body's pivot at (x, y, z), metres in the current modelview frame.
    /// Walks the tree of parts on the matrix stack, which is afterwards as it was.
    void draw_tank(float x, float y, float z) const;

private:
    void draw_part(tank::Part part) const;

    const TankLists& lists_;
    const tank::Layout& layout_;
    const tank::JointAngles& joints_;
};

} // namespace scene
