#pragma once

#include "tank/joint.h"
#include "tank/mesh_box.h"
#include "tank/part.h"

#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace tank {

/// Says about what a part turns within its first joint. Metres.
struct Turn
{
    glm::vec3 pivot; ///< in the first joint's frame
    glm::vec3 axis;  ///< unit length; along X, Y or Z, either way
    Joint joint;
};

/// Says where a part hangs, about what it turns, and how its mesh lies in it. Metres and radians.
///
///     turned(part) = joint(parent) * T(pivot) * R(axis, angle of the part's joint)
///     joint(part)  = turned(part) * T(second.pivot) * R(second.axis, angle of second.joint), if it has one
///     mesh(part)   = joint(part) * R_y(mesh_yaw) * T(mesh_offset)
///
/// Children hang in the joint's frame; only the part's own mesh is moved by the yaw and the offset.
struct PartPlacement
{
    Part parent;           ///< the part itself for the body
    glm::vec3 pivot;       ///< in the parent's joint frame; for the body from the tank's position
    glm::vec3 axis;        ///< unit length; along X, Y or Z, either way
    glm::vec3 mesh_offset; ///< from the innermost pivot to the mesh's origin, before mesh_yaw turns it
    double mesh_yaw;       ///< about +Y
    MeshKind mesh;
    Joint joint;
    std::optional<Turn> second = std::nullopt;
};

/// Holds the tree of parts. Precondition everywhere: a parent comes before its children, the body is the
/// root.
struct Layout
{
    std::array<PartPlacement, PART_COUNT> parts;

    constexpr const PartPlacement& operator[](Part part) const { return parts[index_of(part)]; }
    constexpr PartPlacement& operator[](Part part) { return parts[index_of(part)]; }
};

/// Returns the layout of our own tank: standing on y = 0, gun along +Z, left along +X.
Layout default_layout();

/// Returns the boxes of our own meshes, metres: what tells them from any others.
MeshBoxes default_boxes();

/// Returns a layout whose lengths are `factor` times as long.
Layout scaled(const Layout& layout, double factor);

/// Calls visit(child) for every part that hangs directly on `parent`, in the order of Part.
/// Recursing into each child walks the whole tree, as drawing does.
template <class Visit> void for_each_child(const Layout& layout, Part parent, Visit&& visit)
{
    for (Part part : ALL_PARTS) {
        if (part != parent && layout[part].parent == parent) {
            visit(part);
        }
    }
}

} // namespace tank
