#include "scene/tank/tank_lists.h"

#include "scene/tank/draw_low_obj.h"

#include <cmath>
#include <numbers>

#include <GL/gl.h>

namespace scene {
namespace {

constexpr GLsizei LIST_COUNT = tank::MESH_KIND_COUNT;

/// Puts new names in the place of old ones, whose lists are deleted. Returns false when there are none left.
bool rename_lists(GLuint& first, GLsizei count)
{
    if (first != 0) {
        glDeleteLists(first, count);
    }
    first = glGenLists(count);
    return first != 0;
}

} // namespace

bool TankLists::load(const Meshes& objs, unsigned& first_list, void (*draw)(const mesh::ObjMesh&))
{
    if (!rename_lists(first_list, LIST_COUNT)) {
        return false;
    }
    for (unsigned i = 0; i < objs.size(); ++i) {
        glNewList(first_list + i, GL_COMPILE);
        draw(objs[i]);
        glEndList();
    }
    return true;
}

bool TankLists::load_tank_objs(const Meshes& objs, const assets::TrackLinks& links)
{
    if (first_track_list_ != 0) {
        glDeleteLists(first_track_list_, TRACK_LIST_COUNT);
        first_track_list_ = 0;
    }
    links_ = links;
    if (!links.any()) {
        return load(objs, first_list_, draw_obj);
    }
    const std::size_t body = tank::index_of(tank::MeshKind::body);
    Meshes resting = objs;
    resting[body] = assets::without_links(objs[body], links);
    return load(resting, first_list_, draw_obj) && load_links(objs[body]);
}

bool TankLists::load_links(const mesh::ObjMesh& body)
{
    first_track_list_ = glGenLists(TRACK_LIST_COUNT);
    if (first_track_list_ == 0) {
        return false;
    }
    for (unsigned i = 0; i < TRACK_LIST_COUNT; ++i) {
        const double way = static_cast<double>(i % PHASES) / PHASES;
        glNewList(first_track_list_ + i, GL_COMPILE);
        draw_obj(assets::moved_links(body, links_, static_cast<assets::Side>(i / PHASES), way));
        glEndList();
    }
    return true;
}

bool TankLists::load_low_detail_tank_objs(const Meshes& objs, const assets::LowPaint& paint)
{
    if (!rename_lists(first_low_list_, LOW_LIST_COUNT)) {
        return false;
    }
    for (unsigned i = 0; i < LOW_LIST_COUNT; ++i) {
        const std::size_t mesh = i / YAWS;
        const LowPose pose{.yaw = 2.0 * std::numbers::pi * (i % YAWS) / YAWS,
                           .turns_about_x = mesh == tank::index_of(tank::MeshKind::wheel)};
        glNewList(first_low_list_ + i, GL_COMPILE);
        draw_low_obj(objs[mesh], paint[mesh], pose);
        glEndList();
    }
    return true;
}

unsigned TankLists::low_list(tank::MeshKind mesh, double yaw) const
{
    if (first_low_list_ == 0) {
        return 0;
    }
    const double turns = yaw / (2.0 * std::numbers::pi);
    const auto nearest = static_cast<unsigned>(std::lround((turns - std::floor(turns)) * YAWS)) % YAWS;
    return first_low_list_ + static_cast<unsigned>(tank::index_of(mesh)) * YAWS + nearest;
}

std::optional<tank::MeshKind> TankLists::low_mesh_of(unsigned list) const
{
    if (first_low_list_ == 0 || list < first_low_list_ || list >= first_low_list_ + LOW_LIST_COUNT) {
        return std::nullopt;
    }
    return static_cast<tank::MeshKind>((list - first_low_list_) / YAWS);
}

unsigned TankLists::track_list(assets::Side side, double angle) const
{
    if (first_track_list_ == 0) {
        return 0;
    }
    const auto phase = static_cast<unsigned>(assets::link_phase(links_, angle, PHASES));
    return first_track_list_ + static_cast<unsigned>(side) * PHASES + phase;
}

bool TankLists::is_track_list(unsigned list) const
{
    return first_track_list_ != 0 && list >= first_track_list_ && list < first_track_list_ + TRACK_LIST_COUNT;
}

} // namespace scene
