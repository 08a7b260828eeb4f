#pragma once

#include "assets/low_paint.h"
#include "assets/track_links.h"
#include "mesh/obj_mesh.h"
#include "scene/tank/draw_obj.h"
#include "tank/part.h"

#include <array>
#include <optional>

namespace scene {

/// The display lists of the tank's five meshes, those of the five low-detail ones, and those of the five
/// shapes that throw its shadow. Because a list cannot change, there are several for what does: for a body
/// whose tracks have links, a list more for each side and step of a link's way to the next one's place; for
/// each low-detail mesh, one for each of the ways round from which the sun can shine on it. They belong to
/// the context that was current when they were compiled, and go with it.
class TankLists
{
public:
    using Meshes = std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT>;

    /// Compiles each mesh into a display list of its own, in the order of tank::MeshKind.
    /// The body's list is without what `links` says to move, which track_list() has.
    /// Called again, it replaces the lists. Returns false when OpenGL has no names for lists left.
    bool load_tank_objs(const Meshes& objs, const assets::TrackLinks& links = {});

    /// Does the same with the meshes of the low-detail tank, into lists of their own, coloured by the paint
    /// of their faces and the light; their tracks are one piece.
    bool load_low_detail_tank_objs(const Meshes& objs, const assets::LowPaint& paint = {});

    /// Does the same with the meshes whose shadow is drawn: their corners alone.
    bool load_shapes(const Meshes& objs) { return load(objs, first_shape_list_, draw_shape); }

    /// Returns the name of a mesh's display list; 0 before load_tank_objs.
    unsigned list(tank::MeshKind mesh) const { return list_after(first_list_, mesh); }

    /// Returns the list of what moves of a side's track, in the body's frame, where its wheels have turned by
    /// an angle in radians; 0 if nothing moves.
    unsigned track_list(assets::Side side, double angle) const;

    /// Tells whether a list is one of those that track_list() can return.
    bool is_track_list(unsigned list) const;

    /// Returns that of the low-detail mesh where it is turned by `yaw` about +Y in the world, radians, as
    /// nearly as there are lists; 0 before load_low_detail_tank_objs.
    unsigned low_list(tank::MeshKind mesh, double yaw) const;

    /// Returns the low-detail mesh that a list draws, in whatever light; nothing for any other list.
    std::optional<tank::MeshKind> low_mesh_of(unsigned list) const;

    /// Returns that of the shape that throws the mesh's shadow; 0 before load_shapes.
    unsigned shape_list(tank::MeshKind mesh) const { return list_after(first_shape_list_, mesh); }

private:
    /// A step of a link's way is some two centimetres then, which is less than the tank moves between two
    /// pictures at any but a crawling speed.
    static constexpr unsigned PHASES = 10;

    /// From one of these to the next what the sun gives a side changes by a fifteenth, or six of 255.
    static constexpr unsigned YAWS = 24;
    static constexpr unsigned LOW_LIST_COUNT = tank::MESH_KIND_COUNT * YAWS;
    static constexpr unsigned TRACK_LIST_COUNT = assets::SIDE_COUNT * PHASES;

    static bool load(const Meshes& objs, unsigned& first_list, void (*draw)(const mesh::ObjMesh&));
    bool load_links(const mesh::ObjMesh& body);
    static unsigned list_after(unsigned first_list, tank::MeshKind mesh)
    {
        return first_list == 0 ? 0 : first_list + static_cast<unsigned>(tank::index_of(mesh));
    }

    unsigned first_list_ = 0;
    unsigned first_low_list_ = 0; ///< the body's by their yaw, then those of the others
    unsigned first_shape_list_ = 0;
    unsigned first_track_list_ = 0; ///< the left side's phases, then the right one's
    assets::TrackLinks links_;
};

} // namespace scene
