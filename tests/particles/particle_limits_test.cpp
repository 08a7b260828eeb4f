#include "one_particle.h"
#include "particles/presets.h"
#include "particles/random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace particles {
namespace {

/// The settings that push all limits at once.
ParticleSettings extreme()
{
    ParticleSettings settings;
    settings.maximum_particles = 300;
    settings.release_count = 50;
    settings.life = MAX_LIFE;
    settings.life_variance = 1.0;
    settings.position = {10'000.0f, -10'000.0f, 10'000.0f};
    settings.position_variance = {10'000.0f, 0.0f, 10'000.0f};
    settings.velocity = {-1000.0f, 1000.0f, 1000.0f};
    settings.velocity_variance = 1000.0;
    settings.gravity = {1000.0f, -1000.0f, 1000.0f};
    settings.wind = {1000.0f, 1000.0f, -1000.0f};
    settings.planes = {
        CollisionPlane{.normal = {1000.0f, 1000.0f, 0.0f}, .point = {10'000.0f, 0.0f, 0.0f}},
        CollisionPlane{.normal = {-0.001f, 0.0f, 0.0f}, .restitution = 1.0f, .friction = 10.0f},
        CollisionPlane{.normal = {0.0f, -1.0f, 1.0f}, .restitution = 0.0f}};
    settings.plane_count = 3;
    return settings;
}

void expect_finite(const ParticleSystem& system)
{
    const ParticleView view = system.view();
    for (const std::span<const float> values :
         {view.x, view.y, view.z, view.velocity_x, view.velocity_y, view.velocity_z, view.age, view.life}) {
        for (const float value : values) {
            ASSERT_TRUE(std::isfinite(value));
        }
    }
    for (std::size_t i = 0; i < view.count(); ++i) {
        ASSERT_LT(view.age[i], view.life[i]);
        ASSERT_TRUE(std::isfinite(view.size(i)));
        ASSERT_TRUE(std::isfinite(view.streak_end(i).y));
        view.colour(i);
    }
}

TEST(ParticleSystem, IsFiniteAfterAnyStep)
{
    const double steps[] = {0.0,
                            std::numeric_limits<double>::denorm_min(),
                            1e-300,
                            1e-40,
                            1e-20,
                            1e-9,
                            1e-4,
                            TICK,
                            0.3,
                            1.0,
                            7.0,
                            59.9,
                            60.0,
                            60.1,
                            1e4,
                            1e9,
                            1e38,
                            1e300,
                            std::numeric_limits<double>::max()};
    std::vector<ParticleSettings> all;
    for (const Preset& row : presets()) {
        all.push_back(row.settings);
        all.back().releases = true;
    }
    for (const double air_resistance : {0.0, 1e-300, 1.0, 1000.0}) {
        all.push_back(extreme());
        all.back().air_resistance = air_resistance;
    }
    for (const ParticleSettings& settings : all) {
        ParticleSystem system = configured(settings);
        Random random(1, 0);
        for (const double seconds : steps) {
            ASSERT_TRUE(system.step(seconds));
            expect_finite(system);
            // And after any other.
            ASSERT_TRUE(system.step(steps[static_cast<std::size_t>(random.uniform() * std::size(steps))]));
            expect_finite(system);
        }
    }
}

TEST(ParticleSystem, RefusesAStepThatIsNoTimeAndStaysAsItWas)
{
    ParticleSystem system = configured(preset(PresetName::shower).settings);
    system.step(0.2);
    const ParticleSystem before = system;
    for (const double seconds :
         {-1.0, -1e-300, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_FALSE(system.step(seconds));
        EXPECT_TRUE(system == before);
    }
    EXPECT_TRUE(system.step(0.0));
    EXPECT_TRUE(system == before) << "no time changes nothing";
}

TEST(ParticleSystem, RefusesASourceThatIsNone)
{
    ParticleSystem system = configured(preset(PresetName::sparks).settings);
    const ParticleSystem before = system;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(system.burst(100, {0.0f, nan, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(system.burst(100, {0.0f, 0.0f, 0.0f}, {1e30F, 0.0f, 0.0f}));
    EXPECT_FALSE(system.burst(-1, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(system.set_source({nan, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_TRUE(system.burst(0, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_TRUE(system == before);
}

TEST(ParticleSystem, RefusesSettingsThatCannotBeAndStaysAsItWas)
{
    ParticleSystem system = configured(preset(PresetName::shower).settings);
    system.step(0.2);
    const ParticleSystem before = system;
    ParticleSettings settings = system.settings();
    settings.maximum_particles = 5;
    settings.gravity.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(system.configure(settings), "The gravity must be from -1000 to 1000 m/s^2 along each axis.");
    EXPECT_TRUE(system == before);
}

TEST(ParticleSystem, WithoutPlacesOrWithoutLifeShowsNothing)
{
    ParticleSystem none;
    none.burst(10, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    EXPECT_TRUE(none.step(1.0));
    EXPECT_EQ(none.live(), 0u);
    EXPECT_EQ(none.capacity(), 0u);
    EXPECT_FALSE(none.is_active());

    ParticleSettings settings;
    settings.life = 0.0;
    ParticleSystem lifeless = configured(settings);
    lifeless.burst(10, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    EXPECT_TRUE(lifeless.step(1.0));
    EXPECT_EQ(lifeless.live(), 0u);
    EXPECT_EQ(lifeless.counts().refused, 0u);
    EXPECT_EQ(lifeless.counts().ended, lifeless.counts().released);
    EXPECT_FALSE(lifeless.is_active());
}

TEST(ParticleSystem, HoldsAMillionParticles)
{
    ParticleSettings settings = preset(PresetName::bounce).settings;
    settings.maximum_particles = MAX_PARTICLES;
    settings.release_count = MAX_PARTICLES;
    settings.release_interval = 1.0;
    ParticleSystem system = configured(settings);
    system.step(TICK);
    EXPECT_EQ(system.live(), static_cast<std::size_t>(MAX_PARTICLES));
    EXPECT_EQ(system.free(), 0u);
    system.step(TICK);
    expect_finite(system);
    system.set_releasing(false);
    system.step(5.0);
    EXPECT_EQ(system.live(), 0u);
}

} // namespace
} // namespace particles
