#pragma once

#include "app/commands/commands.h"
#include "app/state/outcome.h"
#include "app/state/state.h"
#include "app/state/ticks.h"
#include "assets/assets.h"

#include <string_view>

namespace app {

/// Executes a command and returns what happened. Refused: a value that is not a number or infinite, or
/// neither 0 nor 1 where those are asked for; and what the command itself refuses. value: see CommandKind.
/// Values beyond a field's limits are clamped or go round. What matters to a replay ends the event that links
/// would replay, when it changes. `set` puts the value on the field's grid, so that the same number in a link
/// gives the same state. assets: of the tank that is shown. Precondition: command is a row of commands().
Outcome apply(State& state, const assets::Assets& assets, const Command& command, double value);

/// Executes the command with that name; an unknown name is refused.
Outcome apply(State& state, const assets::Assets& assets, std::string_view name, double value);

/// Advances the state by one tick: moves what is held and what flies. Opposite holds cancel; limits are
/// reached but not passed. What the projectile meets on its way is found by a Simulation.
/// Returns what happened.
Outcome step(State& state, const assets::Assets& assets);

} // namespace app
