#pragma once

#include "particles/colour_table.h"
#include "particles/contact.h"
#include "particles/emitter.h"
#include "particles/particle_store.h"
#include "particles/particle_view.h"
#include "particles/settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>

namespace particles {

/// Counts what became of all particles since the last restart: living = released - ended.
struct ParticleCounts
{
    std::uint64_t released = 0; ///< those that got a place, or whose life was over within the same step
    std::uint64_t ended = 0;    ///< those among them whose life is over
    std::uint64_t refused = 0;  ///< those for which no place was free

    friend bool operator==(const ParticleCounts&, const ParticleCounts&) = default;
};

/// Releases particles and moves them until their life is over: the lab's particle system.
///
/// A plain value: copy it to keep a state, assign it to go back to one, compare it. The same seed, settings
/// and calls give the same particles on every machine, bit for bit. Only configure() allocates, and only when
/// the number of places changes. Not for several threads at once.
class ParticleSystem
{
public:
    /// Makes a system without places, in which nothing happens until configure().
    ParticleSystem();

    /// Takes settings over. Returns "", or what validate() says; then nothing has changed.
    /// What lives goes on under the new settings, but for its life and what sticks; places that are no more
    /// are taken from those released last. A new number of places allocates.
    [[nodiscard]] std::string configure(const ParticleSettings& settings);

    /// Ends all particles and bursts and begins again, with the random numbers of `seed`.
    void restart(std::uint64_t seed);

    /// Advances by some seconds: what lives ages, ends or moves; what is due is released.
    /// Motion is exact, so the length of steps does not matter, but for rounding and for which particles
    /// find a place where there are too few. The time cost is that of the living and of what is due.
    /// More than MAX_LIFE is taken as that: all that lived before is over then.
    /// False, and nothing happens, when seconds is negative, infinite or not a number.
    bool step(double seconds);

    /// Releases `count` particles, the first at once in the next step, the others evenly within a release
    /// interval. Above Emitter::MAX_BURSTS at a time, the oldest one's rest is released now.
    /// False, and nothing happens, when the count is negative or the source is not valid: see
    /// is_valid_source().
    bool burst(int count, const glm::vec3& position, const glm::vec3& velocity);

    /// Moves the place from which particles are released from now on, and the velocity they get.
    /// False, and nothing happens, when it is not valid: see is_valid_source().
    bool set_source(const glm::vec3& position, const glm::vec3& velocity);

    /// Turns releasing by itself on or off; turned on, it begins with a release at once.
    void set_releasing(bool releases);

    const ParticleSettings& settings() const { return settings_; }
    const ParticleCounts& counts() const { return counts_; }
    const Emitter& emitter() const { return emitter_; }
    std::uint64_t seed() const { return seed_; }

    /// Places; capacity() == live() + free() always.
    std::size_t capacity() const { return store_.capacity(); }
    std::size_t live() const { return store_.live(); }
    std::size_t free() const { return store_.capacity() - store_.live(); }

    /// Tells whether something lives or will, without any further call but step().
    bool is_active() const;

    /// Returns the living particles for drawing, without copying. It costs nothing.
    ParticleView view() const;

    friend bool operator==(const ParticleSystem&, const ParticleSystem&) = default;

private:
    void release(const Release& release);

    Forces forces() const;
    std::span<const Wall> walls() const;

    ParticleSettings settings_;
    ColourTable colours_{}; ///< of the settings
    std::array<Wall, ParticleSettings::MAX_PLANES> walls_{};
    std::uint64_t seed_ = 1;
    Emitter emitter_;
    ParticleCounts counts_;
    ParticleStore store_;
};

/// Returns what changes while a system runs, as bytes, the same on every machine: the seed, the counts, what
/// is due and the living. The settings are not in it. Equal systems have equal bytes.
std::string serialised(const ParticleSystem& system);

/// Returns the 64-bit FNV-1a hash of serialised(system), without making it.
std::uint64_t hash(const ParticleSystem& system);

} // namespace particles
