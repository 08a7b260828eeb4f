#include "app/commands/pointer.h"

#include "app/state/fields.h"
#include "app/view/camera_view.h"

#include <array>
#include <glm/geometric.hpp>

namespace app {

namespace {

/// Nearer than this, in window heights, a pointer means a handle: as wide as a finger.
constexpr double NEAR_ENOUGH = 0.04;

using Ids = std::array<FieldId, 3>;

constexpr Ids fields_of(Handle handle)
{
    switch (handle) {
    case Handle::point:
        break;
    case Handle::line_a:
        return {FieldId::line_ax, FieldId::line_ay, FieldId::line_az};
    case Handle::line_b:
        return {FieldId::line_bx, FieldId::line_by, FieldId::line_bz};
    }
    return {FieldId::point_x, FieldId::point_y, FieldId::point_z};
}

glm::dvec3 place_of(const State& state, Handle handle)
{
    const Ids ids = fields_of(handle);
    return {field(ids[0]).get(state), field(ids[1]).get(state), field(ids[2]).get(state)};
}

bool is_drawn(Probe probe, Handle handle)
{
    return handle == Handle::point ? probe == Probe::point : probe != Probe::none && probe != Probe::point;
}

} // namespace

std::optional<Handle> handle_at(const State& state, const assets::Assets& assets, const glm::dvec2& aim)
{
    if (state.camera.view == View::four) {
        return std::nullopt; // the window's middle is none of the views'
    }
    const CameraView camera = camera_view(state, assets);
    const ViewAxes axes = view_axes(camera);
    std::optional<Handle> nearest;
    double nearest_distance = NEAR_ENOUGH;
    for (Handle handle : {Handle::point, Handle::line_a, Handle::line_b}) {
        const glm::dvec3 from_eye = place_of(state, handle) - camera.eye;
        const double depth = glm::dot(from_eye, axes.forward);
        if (!is_drawn(state.projectile.probe, handle) || depth < camera.near_plane) {
            continue;
        }
        const double height = axes.heights_per_depth * depth;
        const glm::dvec2 seen(glm::dot(from_eye, axes.right) / height, glm::dot(from_eye, axes.up) / height);
        const double distance = glm::length(seen - aim);
        if (distance < nearest_distance) {
            nearest = handle;
            nearest_distance = distance;
        }
    }
    return nearest;
}

Outcome move_to_aim(State& state, const assets::Assets& assets)
{
    if (state.camera.view == View::four) {
        return Outcome::refused(std::string(NO_AIM_IN_FOUR_VIEWS));
    }
    const CameraView camera = camera_view(state, assets);
    const ViewAxes axes = view_axes(camera);
    const Handle handle = state.projectile.handle;
    const double depth = glm::dot(place_of(state, handle) - camera.eye, axes.forward);
    if (depth < camera.near_plane) {
        return Outcome::refused("What is to be moved is behind the eye.");
    }
    const glm::dvec3 place = camera.eye + depth * direction_through(axes, state.projectile.aim);
    const Ids ids = fields_of(handle);
    for (int axis = 0; axis < 3; ++axis) {
        const Field& target = field(ids[static_cast<std::size_t>(axis)]);
        target.set(state, within_limits(target, place[axis]));
    }
    state.projectile.aim = glm::dvec2(0.0);
    return {};
}

} // namespace app
