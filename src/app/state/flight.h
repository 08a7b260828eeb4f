#pragma once

#include "app/state/state.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace app {

/// Returns where the shot is now.
glm::dvec3 position_of(const Shot& shot);

/// Returns where the projectile is: in flight, or at rest. Metres.
glm::dvec3 projectile_position(const State& state);

/// Holds the places where the projectile can be, as their two outermost corners. Metres.
struct ProjectileBounds
{
    glm::dvec3 low;
    glm::dvec3 high;
};

/// Returns them: the limits of the fields of the point.
ProjectileBounds projectile_bounds();

/// Makes an event the state's, `age` ticks ago, and flies what it has fired: as a link does it.
/// Returns "", or a sentence when there is nothing to fire along.
std::string begin_event(State& state, EventKind kind, std::uint32_t age);

/// Advances the shot and the event by a tick. A shot ends one tick after it has left the places where the
/// projectile can be, so that every way it went has been a step; the event a second after that.
/// Returns whether the shot has moved or ended, which people see.
bool step_event(State& state);

} // namespace app
