#pragma once

#include "app/state/outcome.h"
#include "app/state/state.h"
#include "assets/assets.h"

#include <glm/vec2.hpp>
#include <optional>

namespace app {

/// Returns the handle that is drawn and seen nearest to a place in the window, if any is near enough to be
/// meant. aim: as in Projectile. Of the point and the line's ends, only those of the probe are there.
std::optional<Handle> handle_at(const State& state, const assets::Assets& assets, const glm::dvec2& aim);

/// Moves what the keys move to where the aim points at, as deep in the picture as it is, and puts the aim
/// back to the middle. Refused where it is behind the eye.
Outcome move_to_aim(State& state, const assets::Assets& assets);

} // namespace app
