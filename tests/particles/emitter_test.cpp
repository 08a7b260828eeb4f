#include "particles/emitter.h"

#include <gtest/gtest.h>
#include <vector>

namespace particles {
namespace {

constexpr double TOLERANCE = 1e-12;

/// Notes at what time each release leaves.
struct Log
{
    std::vector<double> times;
    std::vector<int> counts;
    double now = 0.0; ///< the end of the step

    void advance(Emitter& emitter, const ParticleSettings& settings, double seconds)
    {
        now += seconds;
        emitter.advance(settings, seconds, [this](const Release& release) {
            times.push_back(now - release.age);
            counts.push_back(release.count);
        });
    }
};

TEST(Emitter, ReleasesAtOnceAndThenAtEveryInterval)
{
    ParticleSettings settings;
    settings.release_count = 7;
    settings.release_interval = 0.05;
    for (const double step : {0.5, 0.125, 1.0 / 64.0, 1.0 / 1024.0}) {
        Emitter emitter;
        Log log;
        while (log.now < 0.5) {
            log.advance(emitter, settings, step);
        }
        ASSERT_GE(log.times.size(), 10u) << step;
        for (std::size_t i = 0; i < 10; ++i) {
            EXPECT_NEAR(log.times[i], 0.05 * static_cast<double>(i), TOLERANCE) << step;
            EXPECT_EQ(log.counts[i], 7);
        }
    }
}

TEST(Emitter, ReleasesNothingInNoTimeOrWhenTurnedOff)
{
    ParticleSettings settings;
    Emitter emitter;
    Log log;
    log.advance(emitter, settings, 0.0);
    EXPECT_TRUE(log.times.empty());
    settings.releases = false;
    log.advance(emitter, settings, 10.0);
    EXPECT_TRUE(log.times.empty());
}

TEST(Emitter, ReleasesABurstOneByOneEvenlyWhateverTheSteps)
{
    ParticleSettings settings;
    settings.releases = false;
    for (const double step : {1.0, 0.0625, 1.0 / 1024.0}) {
        Emitter emitter;
        Log log;
        emitter.begin({{}, 100, 0, 0.05, 0.0}, [](const Release&) { FAIL(); });
        while (log.now < 1.0) {
            log.advance(emitter, settings, step);
        }
        ASSERT_EQ(log.times.size(), 100u) << step;
        for (std::size_t i = 0; i < 100; ++i) {
            EXPECT_NEAR(log.times[i], 0.0005 * static_cast<double>(i), TOLERANCE);
        }
        EXPECT_TRUE(emitter.bursts().empty());
    }
}

TEST(Emitter, LosesNoParticleOfTooManyBursts)
{
    ParticleSettings settings;
    settings.releases = false;
    Emitter emitter;
    int at_once = 0;
    for (int i = 0; i < 20; ++i) {
        emitter.begin({{}, 10, 0, 0.05, 0.0}, [&](const Release& rest) { at_once += rest.count; });
    }
    EXPECT_EQ(at_once, 10 * (20 - static_cast<int>(Emitter::MAX_BURSTS)));
    Log log;
    log.advance(emitter, settings, 1.0);
    EXPECT_EQ(log.times.size() + static_cast<std::size_t>(at_once), 200u);
}

TEST(Emitter, KeepsTheSourceOfEachBurst)
{
    ParticleSettings settings;
    settings.releases = false;
    Emitter emitter;
    const auto ignore = [](const Release&) {};
    emitter.begin({{{1.0f, 0.0f, 0.0f}, {}}, 1, 0, 0.1, 0.0}, ignore);
    emitter.begin({{{2.0f, 0.0f, 0.0f}, {}}, 3, 0, 0.1, 0.0}, ignore);
    emitter.begin({{{3.0f, 0.0f, 0.0f}, {}}, 1, 0, 0.1, 0.0}, ignore);
    std::vector<float> sources;
    for (int i = 0; i < 4; ++i) {
        emitter.advance(settings, 0.03,
                        [&](const Release& release) { sources.push_back(release.source.position.x); });
    }
    EXPECT_EQ(sources, (std::vector<float>{1.0f, 2.0f, 3.0f, 2.0f, 2.0f}));
}

} // namespace
} // namespace particles
