#include "app/simulation/sparks.h"

#include "particles/presets.h"

#include <cassert>

namespace app {

namespace {

using particles::ParticleSystem;
using particles::PresetName;

const glm::vec3 AT_REST(0.0f);

void set_up(ParticleSystem& system, PresetName name)
{
    particles::ParticleSettings settings = particles::preset(name).settings;
    settings.releases = false;
    [[maybe_unused]] const std::string fault = system.configure(settings);
    assert(fault.empty());
}

} // namespace

Sparks::Sparks()
{
    for (OfEvent& of_event : of_events_) {
        set_up(of_event.bursts, PresetName::sparks);
        set_up(of_event.shower, PresetName::shower);
    }
}

void Sparks::begin(std::uint64_t seed)
{
    current().shower.set_releasing(false);
    current_ = 1 - current_;
    current().shower.set_releasing(false);
    current().bursts.restart(seed);
    current().shower.restart(~seed); // other numbers than the bursts'
}

void Sparks::extinguish()
{
    begin(0);
    begin(0); // of the event before, too
}

void Sparks::burst(const glm::dvec3& position)
{
    current().bursts.burst(particles::preset(PresetName::sparks).burst_count, glm::vec3(position), AT_REST);
}

void Sparks::shower(const std::optional<glm::dvec3>& position)
{
    if (position) {
        current().shower.set_source(glm::vec3(*position), AT_REST);
    }
    current().shower.set_releasing(position.has_value());
}

void Sparks::step(double seconds)
{
    for (OfEvent& of_event : of_events_) {
        of_event.bursts.step(seconds);
        of_event.shower.step(seconds);
    }
}

bool Sparks::is_active() const
{
    for (const ParticleSystem* system : systems()) {
        if (system->is_active()) {
            return true;
        }
    }
    return false;
}

std::array<const ParticleSystem*, Sparks::SYSTEMS> Sparks::systems() const
{
    const OfEvent& now = of_events_[current_];
    const OfEvent& before = of_events_[1 - current_];
    return {&now.bursts, &now.shower, &before.bursts, &before.shower};
}

std::uint64_t Sparks::hash() const
{
    const OfEvent& now = of_events_[current_];
    return particles::hash(now.bursts) + 3 * particles::hash(now.shower);
}

} // namespace app
