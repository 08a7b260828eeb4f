#include "app/simulation/particle_show.h"

#include "particles/presets.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

/// From the tank's position to where a preset is, to the tank's left at rest. Metres.
const glm::vec3 BESIDE_THE_TANK(8.0f, 0.0f, 0.0f);

/// A preset that comes in bursts is shown with one so often. Seconds.
constexpr double BURST_INTERVAL = 1.0;

} // namespace

particles::ParticleSettings shown_particles(const State& state)
{
    particles::ParticleSettings settings;
    if (state.particles.preset == 0) {
        settings.maximum_particles = 0;
        settings.releases = false;
        return settings;
    }
    const particles::Preset& preset = particles::presets()[state.particles.preset - 1u];
    const glm::vec3 position(static_cast<float>(state.x), 0.0f, static_cast<float>(state.z));
    settings = particles::moved(preset.settings, position + BESIDE_THE_TANK);
    if (preset.burst_count > 0) {
        settings.releases = true;
        settings.release_interval = BURST_INTERVAL;
    }
    // The preset's picture, with more or fewer particles in it.
    const double share = static_cast<double>(state.particles.amount) / settings.maximum_particles;
    const double most = particles::MAX_RELEASE_RATE * settings.release_interval;
    settings.release_count = static_cast<int>(
        std::clamp(std::round(settings.release_count * share), share > 0.0 ? 1.0 : 0.0, std::floor(most)));
    settings.maximum_particles = state.particles.amount;
    return settings;
}

} // namespace app
