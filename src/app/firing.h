#pragma once

#include "app/assets.h"
#include "app/state.h"

#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace app {

/// Returns where the shot is now.
glm::dvec3 position_of(const Shot& shot);

/// Returns where the projectile is: in flight, or at rest. Metres.
glm::dvec3 projectile_position(const State& state);

/// Fires the projectile from end A of its line through end B, with the next seed; in the gunner's view at the
/// aim. What matters to a replay is first put on the grid of links. Returns "", or a sentence: a line of no
/// length has no direction.
std::string fire(State& state, const Assets& assets);

/// Lays the line from the eye, in the gunner's view from the muzzle, through the aim, as far as both are
/// where the projectile can be, fires along it and puts the aim back to the middle. Returns "", or a sentence
/// when that way misses all such places.
std::string fire_at_aim(State& state, const Assets& assets);

/// Makes an event the state's, `age` ticks ago, and flies what it has fired: as a link does it.
/// Returns "", or a sentence when there is nothing to fire along.
std::string begin_event(State& state, EventKind kind, std::uint32_t age);

/// Advances the shot and the event by a tick. A shot ends one tick after it has left the places where the
/// projectile can be, so that every way it went has been a step; the event a second after that.
/// Returns whether the shot has moved or ended.
bool step_event(State& state);

} // namespace app
