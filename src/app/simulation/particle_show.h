#pragma once

#include "app/state/state.h"
#include "particles/settings.h"

namespace app {

/// Returns the settings of the preset that the state shows, beside the tank, with its amount of particles.
/// Without a preset: no places, nothing released.
particles::ParticleSettings shown_particles(const State& state);

} // namespace app
