#include "app/commands/firing.h"

#include "app/state/fields.h"
#include "app/state/flight.h"
#include "app/view/camera_view.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>

namespace app {

namespace {

/// So long is a line that is laid by aiming, at most. Metres.
constexpr double MAX_AIMED_LINE = 20.0;

/// Further along a direction of length 1 than anything is.
constexpr double MAX_PARAMETER = 1e6;

/// The parameters between which a ray is within reach.
struct Span
{
    double from;
    double to;
};

/// Ericson, Real-Time Collision Detection (2005), 5.3.3: slab by slab.
std::optional<Span> within_reach(const glm::dvec3& origin, const glm::dvec3& direction)
{
    const ProjectileBounds box = projectile_bounds();
    Span span{0.0, MAX_PARAMETER};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) {
                return std::nullopt;
            }
            continue;
        }
        const double one = (box.low[axis] - origin[axis]) / direction[axis];
        const double other = (box.high[axis] - origin[axis]) / direction[axis];
        span.from = std::max(span.from, std::min(one, other));
        span.to = std::min(span.to, std::max(one, other));
    }
    if (!(span.from < span.to)) {
        return std::nullopt;
    }
    return span;
}

void put_on_grid(State& state)
{
    for (const Field& field : fields()) {
        if (matters_to_replay(field)) {
            set_grid_value(field, state, grid_value(field, state));
        }
    }
}

void set_on_grid(State& state, std::array<FieldId, 3> ids, const glm::dvec3& value)
{
    for (int axis = 0; axis < 3; ++axis) {
        const Field& target = field(ids[static_cast<std::size_t>(axis)]);
        set_grid_value(target, state, to_grid(target, value[axis]));
    }
}

/// Returns from where a shot at an aim goes, and which way. The gun's sight lies beside the barrel: what
/// leaves the muzzle meets what is seen at the aim so far away.
struct Way
{
    glm::dvec3 from;
    glm::dvec3 direction;
};

Way way_to_aim(const State& state, const assets::Assets& assets)
{
    constexpr double SIGHTED_IN_AT = 200.0;   // metres
    constexpr double BEYOND_THE_MUZZLE = 0.3; // outside of the gun's own sphere
    const CameraView camera = camera_view(state, assets);
    const glm::dvec3 direction = glm::normalize(direction_through(view_axes(camera), state.projectile.aim));
    if (state.camera.view != View::gunner) {
        return {camera.eye, direction};
    }
    const tank::PartMatrices matrices =
        tank::part_matrices(assets.layout, {{state.x, 0.0, state.z}}, state.joints);
    const glm::dmat4 gun(matrices.joint(tank::Part::main_gun));
    const glm::dvec3 muzzle(gun * glm::dvec4(assets.muzzle + glm::vec3(0.0f, 0.0f, BEYOND_THE_MUZZLE), 1.0));
    return {muzzle, glm::normalize(camera.eye + SIGHTED_IN_AT * direction - muzzle)};
}

Outcome fire_along_line(State& state)
{
    State fired = state;
    put_on_grid(fired);
    fired.seed = fired.seed >= LAST_SEED ? FIRST_SEED : fired.seed + 1;
    if (std::string fault = begin_event(fired, EventKind::fire, 0); !fault.empty()) {
        return Outcome::refused(std::move(fault));
    }
    state = fired;
    return {.event_changed = true, .fired = true};
}

} // namespace

Outcome fire(State& state, const assets::Assets& assets)
{
    return state.camera.view == View::gunner ? fire_at_aim(state, assets) : fire_along_line(state);
}

Outcome fire_at_aim(State& state, const assets::Assets& assets)
{
    if (state.camera.view == View::four) {
        return Outcome::refused(std::string(NO_AIM_IN_FOUR_VIEWS));
    }
    const Way way = way_to_aim(state, assets);
    const std::optional<Span> span = within_reach(way.from, way.direction);
    if (!span || span->to - span->from < 0.01) {
        return Outcome::refused("The projectile cannot be anywhere on the way that is aimed along.");
    }
    const double end = std::min(span->to, span->from + MAX_AIMED_LINE);
    State aimed = state;
    using enum FieldId;
    set_on_grid(aimed, {line_ax, line_ay, line_az}, way.from + span->from * way.direction);
    set_on_grid(aimed, {line_bx, line_by, line_bz}, way.from + end * way.direction);
    aimed.projectile.aim = glm::dvec2(0.0);
    Outcome outcome = fire_along_line(aimed);
    if (outcome.refusal.empty()) {
        state = aimed;
    }
    return outcome;
}

} // namespace app
