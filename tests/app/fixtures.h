#pragma once

#include "app/state/state.h"
#include "asset_fixtures.h"

#include <cstdint>
#include <random>

namespace app {

/// Returns a state with random values of every field, anywhere within the limits and mostly off the grid.
State random_state(std::mt19937_64& random);

/// Returns a number in [0, 1).
double next_unit(std::mt19937_64& random);

} // namespace app
