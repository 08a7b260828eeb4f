#pragma once

#include "app/state/outcome.h"
#include "app/state/state.h"
#include "assets/assets.h"

namespace app {

/// Fires the projectile from end A of its line through end B, with the next seed; in the gunner's view at the
/// aim. What matters to a replay is first put on the grid of links. Refused: a line of no length has no
/// direction.
Outcome fire(State& state, const assets::Assets& assets);

/// Lays the line from the eye, in the gunner's view from the muzzle, through the aim, as far as both are
/// where the projectile can be, fires along it and puts the aim back to the middle. Refused where that
/// way misses all such places.
Outcome fire_at_aim(State& state, const assets::Assets& assets);

} // namespace app
