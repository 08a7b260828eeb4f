#include "app/state/flight.h"

#include "app/state/fields.h"
#include "app/state/ticks.h"

#include <glm/geometric.hpp>
#include <string_view>

namespace app {

namespace {

constexpr std::string_view NO_DIRECTION =
    "Both ends of the line are the same, so there is no direction to fire in.";

/// Sparks are all out so many ticks after the shot has ended.
constexpr std::uint32_t AFTERGLOW = TICKS_PER_SECOND;

bool is_within_bounds(const glm::dvec3& point)
{
    const ProjectileBounds box = projectile_bounds();
    return point.x >= box.low.x && point.y >= box.low.y && point.z >= box.low.z && point.x <= box.high.x &&
           point.y <= box.high.y && point.z <= box.high.z;
}

} // namespace

ProjectileBounds projectile_bounds()
{
    const Field& x = field(FieldId::point_x);
    const Field& y = field(FieldId::point_y);
    const Field& z = field(FieldId::point_z);
    return {{x.minimum, y.minimum, z.minimum}, {x.maximum, y.maximum, z.maximum}};
}

glm::dvec3 position_of(const Shot& shot)
{
    return shot.origin + shot.velocity * (static_cast<double>(shot.age) / TICKS_PER_SECOND);
}

glm::dvec3 projectile_position(const State& state)
{
    return state.shot.flies ? position_of(state.shot) : state.projectile.point;
}

std::string begin_event(State& state, EventKind kind, std::uint32_t age)
{
    state.event = {};
    state.shot = {};
    if (kind == EventKind::none) {
        return {};
    }
    if (kind == EventKind::fire) {
        const glm::dvec3 way = state.projectile.b - state.projectile.a;
        const double length = glm::length(way);
        if (length == 0.0) {
            return std::string(NO_DIRECTION);
        }
        state.shot = {.flies = true,
                      .origin = state.projectile.a,
                      .velocity = way * (state.projectile.speed / length),
                      .age = 0};
    }
    state.event = {kind, 0};
    for (std::uint32_t tick = 0; tick < age && state.event.kind != EventKind::none; ++tick) {
        step_event(state);
    }
    return {};
}

bool step_event(State& state)
{
    const bool flew = state.shot.flies;
    if (flew && is_within_bounds(position_of(state.shot)) && state.shot.age < MAX_REPLAY_TICKS) {
        ++state.shot.age;
    } else {
        state.shot.flies = false;
    }
    if (state.event.kind != EventKind::none) {
        ++state.event.age;
        const bool is_out = state.event.kind == EventKind::fire && !state.shot.flies &&
                            state.event.age > state.shot.age + AFTERGLOW;
        if (is_out || state.event.age > MAX_REPLAY_TICKS) {
            state.event = {};
        }
    }
    if (state.event.kind == EventKind::none && !state.shot.flies) {
        state.shot = {};
    }
    return flew;
}

} // namespace app
