#include "app/view/frame.h"

#include "app/state/flight.h"
#include "lod/level_selector.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace app {

namespace {

/// A projectile is drawn no smaller than this. Metres.
constexpr double MIN_DRAWN_RADIUS = 0.08;

/// Lines without an end are drawn so far beyond their handles: further than anything can be seen. Metres.
constexpr double FAR_AWAY = 1500.0;

constexpr lod::Level to_app(lod::Level level)
{
    return level == lod::Level::low ? lod::Level::low : lod::Level::high;
}

lod::Level level_of(const State& state)
{
    switch (state.show.detail) {
    case Detail::low:
        return lod::Level::low;
    case Detail::automatic:
        return to_app(lod::level_at(eye_distance(state), state.show.threshold));
    case Detail::high:
    case Detail::both:
        break;
    }
    return lod::Level::high;
}

collision::PartSet shown_parts(const State& state)
{
    collision::PartSet parts;
    for (tank::Part part : tank::ALL_PARTS) {
        if (is_shown(state.show.parts, part)) {
            parts.insert(tank::index_of(part));
        }
    }
    return parts;
}

ProbeInFrame probe_of(const Projectile& projectile)
{
    const glm::dvec3 a = projectile.a;
    const glm::dvec3 b = projectile.b;
    const double length = glm::length(b - a);
    const glm::dvec3 beyond = length > 0.0 ? (b - a) * (FAR_AWAY / length) : glm::dvec3(0.0);
    const bool has_end = projectile.probe != Probe::ray && projectile.probe != Probe::line;
    return {.probe = projectile.probe,
            .point = projectile.point,
            .point_radius = std::max(projectile.radius, MIN_DRAWN_RADIUS),
            .a = a,
            .b = b,
            .from = projectile.probe == Probe::line ? a - beyond : a,
            .to = has_end ? b : b + beyond,
            .handle = projectile.handle};
}

AxisInFrame shown_axis(const State& state, const assets::Assets& assets)
{
    using tank::Joint;
    switch (state.show.axis) {
    case AxisShown::off:
    case AxisShown::moving:
        return {};
    case AxisShown::body:
        return axis_of(state, assets, Joint::heading);
    case AxisShown::turret:
        return axis_of(state, assets, Joint::turret);
    case AxisShown::main_gun:
        return axis_of(state, assets, Joint::main_gun);
    case AxisShown::secondary_gun:
        return axis_of(state, assets, Joint::secondary_gun);
    case AxisShown::secondary_gun_pitch:
        return axis_of(state, assets, Joint::secondary_gun_pitch);
    case AxisShown::wheels:
        return axis_of(state, assets, Joint::wheels_left);
    }
    return {};
}

/// Returns the axis through a pivot of a frame.
AxisInFrame axis_in(const glm::dmat4& frame, const glm::dvec3& pivot, const glm::dvec3& axis)
{
    return {.is_shown = true,
            .origin = glm::dvec3(frame * glm::dvec4(pivot, 1.0)),
            .direction = glm::normalize(glm::dmat3(frame) * axis)};
}

/// Divides the window among the views: one, or four as a drawing has them, the side's beside the front's and
/// that from above below the side's.
void add_panes(Frame& frame, const State& state)
{
    frame.panes = {{.left = 0, .bottom = 0, .parts = 1, .camera = frame.camera}};
    if (state.camera.view == View::four) {
        frame.panes = {{.left = 0, .bottom = 1, .parts = 2, .camera = side_view(state, SeenFrom::front)},
                       {.left = 1, .bottom = 1, .parts = 2, .camera = side_view(state, SeenFrom::left)},
                       {.left = 1, .bottom = 0, .parts = 2, .camera = side_view(state, SeenFrom::above)},
                       {.left = 0, .bottom = 0, .parts = 2, .camera = frame.camera}};
    }
}

} // namespace

AxisInFrame axis_of(const State& state, const assets::Assets& assets, tank::Joint joint)
{
    const tank::PartMatrices matrices =
        tank::part_matrices(assets.layout, {{state.x, 0.0, state.z}}, state.joints);
    // A turn about an axis does not turn the axis, so the frame that the turn ends in has it, too; only a
    // part's first axis is to be found from its parent's frame, as the second joint turns it.
    for (tank::Part part : tank::ALL_PARTS) {
        const tank::PartPlacement& placement = assets.layout[part];
        const glm::dmat4 own(matrices.joint(part));
        if (placement.second && placement.second->joint == joint) {
            return axis_in(own, glm::dvec3(0.0), placement.second->axis);
        }
        if (placement.joint == joint) {
            return placement.second ? axis_in(glm::dmat4(matrices.joint(placement.parent)), placement.pivot,
                                              placement.axis)
                                    : axis_in(own, glm::dvec3(0.0), placement.axis);
        }
    }
    return {};
}

Frame make_frame(const State& state, const assets::Assets& assets)
{
    Frame frame{};
    frame.camera = camera_view(state, assets);
    add_panes(frame, state);
    frame.reticle = state.camera.view == View::gunner;
    frame.tanks = {{.position = {state.x, 0.0, state.z}, .joints = state.joints, .level = level_of(state)}};
    if (state.show.detail == Detail::both) {
        app::TankInFrame& low = frame.tanks.push_back(frame.tanks[0]);
        low.position.x += BESIDE;
        low.level = lod::Level::low;
    }
    frame.parts = shown_parts(state);
    frame.ground = state.show.ground;
    frame.wireframe = state.show.wireframe;
    frame.probe = probe_of(state.projectile);
    frame.shot = {.flies = state.shot.flies,
                  .position = position_of(state.shot),
                  .velocity = state.shot.velocity,
                  .radius = std::max(state.projectile.radius, MIN_DRAWN_RADIUS)};
    frame.axis = shown_axis(state, assets);
    frame.threshold = state.show.threshold;
    return frame;
}

} // namespace app
