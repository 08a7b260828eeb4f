#pragma once

#include "app/state/state.h"
#include "assets/assets.h"

#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace app {

/// Fires the projectile from end A of its line through end B, with the next seed; in the gunner's view at the
/// aim. What matters to a replay is first put on the grid of links. Returns "", or a sentence: a line of no
/// length has no direction.
std::string fire(State& state, const assets::Assets& assets);

/// Lays the line from the eye, in the gunner's view from the muzzle, through the aim, as far as both are
/// where the projectile can be, fires along it and puts the aim back to the middle. Returns "", or a sentence
/// when that way misses all such places.
std::string fire_at_aim(State& state, const assets::Assets& assets);

} // namespace app
