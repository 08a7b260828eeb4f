#include "one_particle.h"
#include "particles/presets.h"

#include <cmath>
#include <gtest/gtest.h>

namespace particles {
namespace {

TEST(ParticleSystem, FallsAsGalileoSays)
{
    ParticleSettings settings = one_particle();
    settings.gravity = {1.0f, -9.8125f, 0.5f};
    for (const int steps : {1, 2, 60, 1000}) {
        ParticleSystem system = configured(settings);
        system.burst(1, {1.0f, 2.0f, 3.0f}, {4.0f, 5.0f, -6.0f});
        for (int i = 0; i < steps; ++i) {
            system.step(1.5 / steps);
        }
        ASSERT_EQ(system.live(), 1u);
        const glm::dvec3 gravity{settings.gravity};
        const glm::dvec3 velocity{4.0, 5.0, -6.0};
        expect_near(system.view().position(0), glm::dvec3{1.0, 2.0, 3.0} + velocity * 1.5 + gravity * 1.125,
                    2e-4);
        expect_near(system.view().velocity(0), velocity + gravity * 1.5, 2e-4);
        EXPECT_NEAR(system.view().age[0], 1.5, 1e-4);
    }
}

TEST(ParticleSystem, IsSlowedByTheAirAndCarriedByTheWind)
{
    ParticleSettings settings = one_particle();
    settings.gravity = {0.0f, -9.8125f, 0.0f};
    settings.wind = {3.0f, 0.0f, 1.0f};
    settings.air_resistance = 0.75;
    const double k = 0.75;
    const double t = 1.5;
    const glm::dvec3 terminal = glm::dvec3{settings.wind} + glm::dvec3{settings.gravity} / k;
    const glm::dvec3 begin{1.0, 2.0, 3.0};
    const glm::dvec3 velocity{4.0, 5.0, -6.0};
    const glm::dvec3 velocity_then = terminal + (velocity - terminal) * std::exp(-k * t);
    const glm::dvec3 position_then =
        begin + terminal * t + (velocity - terminal) * (1.0 - std::exp(-k * t)) / k;
    for (const int steps : {1, 2, 60, 1000}) {
        ParticleSystem system = configured(settings);
        system.burst(1, glm::vec3{begin}, glm::vec3{velocity});
        for (int i = 0; i < steps; ++i) {
            system.step(t / steps);
        }
        expect_near(system.view().position(0), position_then, 2e-4);
        expect_near(system.view().velocity(0), velocity_then, 2e-4);
    }
}

TEST(ParticleSystem, InTheEndGoesWithTheWind)
{
    ParticleSettings settings = one_particle();
    settings.wind = {3.0f, 0.0f, 1.0f};
    settings.air_resistance = 5.0;
    ParticleSystem system = configured(settings);
    system.burst(1, {0.0f, 0.0f, 0.0f}, {0.0f, 50.0f, 0.0f});
    system.step(10.0);
    expect_near(system.view().velocity(0), {3.0, 0.0, 1.0}, 1e-5);
}

TEST(ParticleSystem, TwoHalfStepsAreOneStepForAllOfAPreset)
{
    for (const Preset& row : presets()) {
        ParticleSettings settings = row.settings;
        settings.releases = true;
        settings.maximum_particles = 10'000;
        ParticleSystem whole = configured(settings);
        whole.step(0.7);
        ParticleSystem half = whole;
        const double seconds = 0.1;
        whole.step(seconds);
        half.step(seconds / 2.0);
        half.step(seconds / 2.0);
        // In no particular order, so sums are compared, and the count of those on the edge of their lives.
        const auto sum = [](const ParticleSystem& system) {
            glm::dvec3 total{0.0};
            for (std::size_t i = 0; i < system.live(); ++i) {
                total += glm::dvec3{system.view().position(i)};
            }
            return total / (static_cast<double>(system.live()) + 1.0);
        };
        EXPECT_EQ(whole.counts().released, half.counts().released) << row.id;
        EXPECT_EQ(whole.live(), half.live()) << row.id;
        expect_near(sum(whole), sum(half), 1e-3);
    }
}

TEST(ParticleSystem, WithALongStepIsWhereItIsWithShortOnes)
{
    // Releases, bursts and contacts fall within the step.
    ParticleSettings settings = preset(PresetName::bounce).settings;
    settings.life_variance = 0.5;
    ParticleSystem at_once = configured(settings);
    ParticleSystem in_parts = configured(settings);
    at_once.burst(50, {0.0f, 3.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    in_parts.burst(50, {0.0f, 3.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    at_once.step(2.0);
    for (int i = 0; i < 120; ++i) {
        in_parts.step(TICK);
    }
    ASSERT_EQ(at_once.live(), in_parts.live());
    EXPECT_EQ(at_once.counts(), in_parts.counts());
    // Numbers of particles differ in order only, so lives identify them.
    int compared = 0;
    const ParticleView a = at_once.view();
    const ParticleView b = in_parts.view();
    for (std::size_t i = 0; i < a.count(); ++i) {
        for (std::size_t j = 0; j < b.count(); ++j) {
            if (a.life[i] == b.life[j] && std::abs(a.age[i] - b.age[j]) < 1e-4F) {
                ++compared;
                expect_near(a.position(i), b.position(j), 0.01);
            }
        }
    }
    EXPECT_GT(compared, 100);
}

} // namespace
} // namespace particles
