// Prints what a step at 100,000 living particles costs, as JSON, natively and under Node alike:
//
//   step_100k_ns         sparks at full number: all fly, thousands bounce, end and are released in each step
//   step_100k_flying_ns  only flying, without a plane
//
// Medians of single steps of 1/60 s, in nanoseconds; *_least_ns is the fastest step, which other processes
// disturb least: compare native and web by that. The hash shows that both did the same work.

#include "particles/particle_system.h"
#include "particles/presets.h"

#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <vector>

namespace {

constexpr int LIVING = 100'000;
constexpr double TICK = 1.0 / 60.0;

struct Durations
{
    double median;
    double least;
};

double time_step(particles::ParticleSystem& system)
{
    const auto begin = std::chrono::steady_clock::now();
    system.step(TICK);
    const auto end = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::nano>(end - begin).count();
}

// Not to be put into its caller: a browser's engine optimises a function when it is called again, but never
// one that it is in, and a program calls a step for each frame.
double (*volatile call_time_step)(particles::ParticleSystem&) = &time_step;

Durations time_steps(particles::ParticleSystem& system)
{
    constexpr int WARM_UP = 60;
    constexpr int COUNT = 400;
    std::vector<double> nanoseconds;
    for (int i = 0; i < WARM_UP + COUNT; ++i) {
        const double duration = call_time_step(system);
        if (i >= WARM_UP) {
            nanoseconds.push_back(duration);
        }
    }
    std::sort(nanoseconds.begin(), nanoseconds.end());
    return {nanoseconds[COUNT / 2], nanoseconds[0]};
}

particles::ParticleSettings full_of_sparks()
{
    particles::ParticleSettings settings = particles::preset(particles::PresetName::sparks).settings;
    settings.maximum_particles = LIVING;
    settings.releases = true;
    settings.release_count = 1000;
    settings.release_interval = 0.001;
    settings.position = {0.0f, 1.0f, 0.0f};
    return settings;
}

particles::ParticleSettings flying()
{
    particles::ParticleSettings settings = full_of_sparks();
    settings.plane_count = 0;
    settings.life = 60.0;
    settings.life_variance = 0.0;
    return settings;
}

} // namespace

int main()
{
    particles::ParticleSystem sparks;
    particles::ParticleSystem flyers;
    if (!sparks.configure(full_of_sparks()).empty() || !flyers.configure(flying()).empty()) {
        return 1;
    }
    const Durations bouncing = time_steps(sparks);
    const Durations flight = time_steps(flyers);
    if (sparks.live() != LIVING || flyers.live() != LIVING) {
        return 1;
    }
    std::printf("{\"step_100k_ns\":%.0f,\"step_100k_least_ns\":%.0f,\"step_100k_flying_ns\":%.0f,"
                "\"step_100k_flying_least_ns\":%.0f,\"hash\":\"%016" PRIx64 "\"}\n",
                bouncing.median, bouncing.least, flight.median, flight.least,
                particles::hash(sparks) ^ particles::hash(flyers));
    return 0;
}
