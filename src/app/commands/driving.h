#pragma once

#include "app/state/fields.h"
#include "app/state/state.h"
#include "assets/assets.h"

#include <array>

namespace app {

/// Holds how fast each field changes, by row of the table of fields: in its unit per second.
using FieldRates = std::array<double, FIELD_COUNT>;

/// Adds to the rates how the tank moves on the ground: `forward` m/s straight ahead, and turning in place by
/// the rate that the heading has. It stands still at the edge of the ground. Each side's wheels roll by the
/// ground that their side covers.
void add_driving(FieldRates& rates, const State& state, const assets::Assets& assets, double forward);

} // namespace app
