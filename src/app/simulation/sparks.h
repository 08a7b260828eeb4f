#pragma once

#include "particles/particle_system.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace app {

/// The sparks of hits: a burst where the projectile touches a part, a weak shower while it stays inside one.
/// Nothing is allocated but when this is made. A new event has sparks of its own, with a seed of its own,
/// while those of the event before burn out.
class Sparks
{
public:
    Sparks();

    /// Begins the sparks of an event: none yet, the random numbers of `seed`.
    void begin(std::uint64_t seed);

    /// Leaves no spark alight, neither of the event that goes on nor of the one before it.
    void extinguish();

    /// Makes one burst. Metres.
    void burst(const glm::dvec3& position);

    /// Lets it shower from a place, or nowhere.
    void shower(const std::optional<glm::dvec3>& position);

    void step(double seconds);

    /// Tells whether anything is alight.
    bool is_active() const;

    static constexpr std::size_t SYSTEMS = 4;

    /// Returns the systems to draw: bursts and shower of this event, then those of the one before.
    std::array<const particles::ParticleSystem*, SYSTEMS> systems() const;

    /// Returns the sum of the hashes of this event's systems.
    std::uint64_t hash() const;

private:
    struct OfEvent
    {
        particles::ParticleSystem bursts;
        particles::ParticleSystem shower;
    };

    OfEvent& current() { return of_events_[current_]; }

    std::array<OfEvent, 2> of_events_;
    std::size_t current_ = 0;
};

} // namespace app
