#pragma once

#include "particles/settings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace particles {

/// Where particles begin, before the variances of the settings. Metres, m/s.
struct Source
{
    glm::vec3 position{0.0f};
    glm::vec3 velocity{0.0f};

    friend bool operator==(const Source&, const Source&) = default;
};

/// Some particles that left a source together, `age` seconds ago.
struct Release
{
    Source source;
    int count;
    double age;
};

/// A burst under way: particles that leave a source one by one, evenly.
struct Burst
{
    Source source;
    int count = 0;
    int released = 0;      ///< so many of them have left
    double duration = 0.0; ///< seconds in which all leave; 0: together
    double elapsed = 0.0;  ///< seconds since it began

    /// Returns the time, in seconds after the burst began, at which the next one leaves.
    double next_time() const { return duration * released / count; }

    friend bool operator==(const Burst&, const Burst&) = default;
};

/// Says when how many particles are to be released: by itself, some together at every release interval, the
/// first of them at once; and those of bursts. Releases fall within steps, not on their ends, so the length
/// of the steps does not matter.
class Emitter
{
public:
    /// How many bursts can be under way together.
    static constexpr std::size_t MAX_BURSTS = 8;

    /// Makes the next release by itself due after at most so many seconds.
    void set_until_release_at_most(double seconds) { until_release_ = std::min(until_release_, seconds); }

    /// Begins a burst; its first particle leaves in the next step. Where too many are under way, what is left
    /// of the oldest leaves now: it is handed to release(const Release&). Precondition: burst.count > 0.
    template <class Sink> void begin(const Burst& burst, Sink release)
    {
        if (burst_count_ == MAX_BURSTS) {
            const Burst& oldest = bursts_[0];
            release(Release{oldest.source, oldest.count - oldest.released, 0.0});
            forget(0);
        }
        bursts_[burst_count_++] = burst;
    }

    /// Hands what leaves within the next seconds to release(const Release&), bursts first.
    /// Precondition: 0 <= seconds <= MAX_LIFE.
    template <class Sink> void advance(const ParticleSettings& settings, double seconds, Sink release)
    {
        for (std::size_t i = 0; i < burst_count_;) {
            Burst& burst = bursts_[i];
            for (; burst.released < burst.count; ++burst.released) {
                const double time = burst.next_time() - burst.elapsed;
                if (time >= seconds) {
                    break;
                }
                release(Release{burst.source, 1, seconds - time});
            }
            burst.elapsed += seconds;
            if (burst.released < burst.count) {
                ++i;
            } else {
                forget(i);
            }
        }
        if (settings.releases) {
            for (; until_release_ < seconds; until_release_ += settings.release_interval) {
                release(Release{{settings.position, settings.velocity},
                                settings.release_count,
                                seconds - until_release_});
            }
            until_release_ -= seconds;
        }
    }

    double until_release() const { return until_release_; }
    std::span<const Burst> bursts() const { return {bursts_.data(), burst_count_}; }

    friend bool operator==(const Emitter&, const Emitter&) = default;

private:
    void forget(std::size_t index)
    {
        std::copy(bursts_.begin() + index + 1, bursts_.begin() + burst_count_, bursts_.begin() + index);
        bursts_[--burst_count_] = Burst{};
    }

    double until_release_ = 0.0; ///< seconds to the next release by itself
    std::array<Burst, MAX_BURSTS> bursts_{};
    std::size_t burst_count_ = 0;
};

} // namespace particles
