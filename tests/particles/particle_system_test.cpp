#include "one_particle.h"
#include "particles/presets.h"
#include "particles/random.h"

#include <chrono>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace particles {
namespace {

TEST(ParticleSystem, NeitherLosesNorLeaksPlacesOverAMillionReleases)
{
    for (const ContactResponse response :
         {ContactResponse::bounce, ContactResponse::stick, ContactResponse::recycle}) {
        ParticleSettings settings = preset(PresetName::bounce).settings;
        settings.maximum_particles = 777;
        settings.release_count = 13;
        settings.release_interval = 0.002;
        settings.life = 0.3;
        settings.life_variance = 1.0;
        settings.planes[0].response = response;
        settings.velocity = {0.0f, 1.0f, 0.0f};
        ParticleSystem system = configured(settings);
        Random random(1, static_cast<std::uint64_t>(response));
        std::uint64_t asked = 0;
        while (system.counts().released < 350'000 && asked < 20'000'000) {
            const std::uint64_t before = system.counts().released + system.counts().refused;
            if (random.uniform() < 0.2) {
                ASSERT_TRUE(system.burst(static_cast<int>(random.uniform() * 300.0), {0.0f, 1.0f, 0.0f},
                                         {1.0f, 1.0f, 1.0f}));
            }
            const double choice = random.uniform();
            ASSERT_TRUE(system.step(choice < 0.1 ? 0.0 : choice < 0.95 ? TICK * choice : choice));
            const ParticleCounts& counts = system.counts();
            ASSERT_EQ(system.capacity(), 777u);
            ASSERT_EQ(system.live() + system.free(), system.capacity());
            ASSERT_EQ(counts.released - counts.ended, system.live());
            ASSERT_EQ(system.view().count(), system.live());
            asked += counts.released + counts.refused - before;
        }
        EXPECT_GE(system.counts().released, 350'000u);
        EXPECT_EQ(asked, system.counts().released + system.counts().refused);
        EXPECT_GT(system.counts().refused, 0u) << "it was full";
        system.set_releasing(false);
        system.step(1.0);
        EXPECT_EQ(system.live(), 0u);
        EXPECT_EQ(system.free(), 777u);
        settings.life_variance = 0.0;
        settings.plane_count = 0;
        settings.releases = false;
        ASSERT_EQ(system.configure(settings), "");
        system.burst(1000, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
        system.step(0.1);
        EXPECT_EQ(system.live(), 777u) << "every place can be had again";
    }
}

TEST(ParticleSystem, KeepsWhoIsThereWhenItIsFull)
{
    ParticleSettings settings = one_particle();
    settings.maximum_particles = 10;
    ParticleSystem system = configured(settings);
    system.burst(10, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    system.step(TICK);
    system.burst(10, {2.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    system.step(TICK);
    EXPECT_EQ(system.live(), 10u);
    EXPECT_EQ(system.counts().refused, 10u);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(system.view().position(i).x, 1.0f);
    }
}

TEST(ParticleSystem, StepCostsWhatLivesNotWhatThereArePlacesFor)
{
    ParticleSettings settings = one_particle();
    settings.maximum_particles = MAX_PARTICLES;
    ParticleSystem system = configured(settings);
    system.burst(3, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 20'000; ++i) {
        system.step(1e-4);
    }
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(system.live(), 3u);
    EXPECT_LT(duration.count(), 2.0) << "touching each of a million places takes far more than 0.1 ms a step";
}

TEST(ParticleSystem, EndsAllParticlesWhenNothingIsReleasedAnyMore)
{
    for (const Preset& row : presets()) {
        ParticleSystem system = configured(row.settings);
        for (int i = 0; i < 100; ++i) {
            if (i % 10 == 0) {
                system.burst(40, {0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
            }
            system.step(TICK);
        }
        EXPECT_TRUE(system.is_active());
        system.set_releasing(false);
        const int life = static_cast<int>((row.settings.life + row.settings.release_interval) * 60.0) + 1;
        for (int i = 0; i < life; ++i) {
            system.step(TICK);
        }
        EXPECT_EQ(system.live(), 0u) << row.id;
        EXPECT_EQ(system.counts().ended, system.counts().released);
        EXPECT_FALSE(system.is_active());
    }
}

TEST(ParticleSystem, VariancesAreRangesAroundTheSettings)
{
    ParticleSettings settings;
    settings.maximum_particles = 5'000;
    settings.releases = false;
    settings.life = 10.0;
    settings.life_variance = 0.25;
    settings.position_variance = {1.0f, 0.0f, 3.0f};
    settings.velocity_variance = 4.0;
    ParticleSystem system = configured(settings);
    system.burst(5'000, {10.0f, 20.0f, 30.0f}, {1.0f, 2.0f, 3.0f});
    system.step(0.05);
    ASSERT_EQ(system.live(), 5'000u);
    glm::vec3 lowest{1e9F};
    glm::vec3 highest{-1e9F};
    float fastest = 0.0f;
    for (std::size_t i = 0; i < system.live(); ++i) {
        const ParticleView view = system.view();
        EXPECT_TRUE(view.life[i] > 7.5f && view.life[i] <= 10.0f);
        const glm::vec3 begin = view.position(i) - view.velocity(i) * view.age[i];
        lowest = glm::min(lowest, begin);
        highest = glm::max(highest, begin);
        fastest = std::max(fastest, glm::length(view.velocity(i) - glm::vec3{1.0f, 2.0f, 3.0f}));
    }
    expect_near(lowest, {9.0, 20.0, 27.0}, 0.01);
    expect_near(highest, {11.0, 20.0, 33.0}, 0.01);
    EXPECT_NEAR(fastest, 4.0, 0.01);
}

TEST(ParticleSystem, KeepsWhatLivesWhenSettingsChange)
{
    ParticleSettings settings = one_particle();
    settings.maximum_particles = 8;
    ParticleSystem system = configured(settings);
    system.burst(8, {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f});
    system.step(0.5);
    settings.gravity = {0.0f, -2.0f, 0.0f};
    settings.maximum_particles = 20;
    ASSERT_EQ(system.configure(settings), "");
    EXPECT_EQ(system.live(), 8u);
    EXPECT_EQ(system.free(), 12u);
    system.step(1.0);
    expect_near(system.view().position(3), {1.5, -1.0, 0.0}, 0.01);
    settings.maximum_particles = 3;
    ASSERT_EQ(system.configure(settings), "");
    EXPECT_EQ(system.live(), 3u);
    EXPECT_EQ(system.free(), 0u);
    EXPECT_EQ(system.counts().released - system.counts().ended, 3u);
}

TEST(ParticleSystem, BeginsToReleaseAtOnceWhenTurnedOn)
{
    ParticleSettings settings;
    settings.release_interval = 10.0;
    ParticleSystem system = configured(settings);
    system.step(TICK);
    EXPECT_EQ(system.counts().released, 1u);
    system.set_releasing(false);
    system.step(1.0);
    system.set_releasing(true);
    system.set_releasing(true);
    system.step(TICK);
    EXPECT_EQ(system.counts().released, 2u);
    settings.release_interval = 0.05;
    ASSERT_EQ(system.configure(settings), "");
    system.step(0.051);
    EXPECT_EQ(system.counts().released, 3u)
        << "a shorter interval is not waited for as long as the one before";
}

TEST(ParticleSystem, FollowsItsSource)
{
    ParticleSettings settings = one_particle();
    settings.releases = true;
    settings.maximum_particles = 2;
    settings.release_interval = 0.1;
    ParticleSystem system = configured(settings);
    system.step(0.05);
    EXPECT_TRUE(system.set_source({5.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    system.step(0.1);
    ASSERT_EQ(system.live(), 2u);
    EXPECT_EQ(system.view().position(0).x, 0.0f);
    EXPECT_EQ(system.view().position(1).x, 5.0f);
    EXPECT_EQ(system.settings().position.x, 5.0f);
}

TEST(ParticleView, FollowsTheRampsOverALife)
{
    ParticleSettings settings = one_particle();
    settings.life = 2.0;
    settings.size = {1.0f, 3.0f};
    settings.colour = {.start = {1.0f, 0.0f, 0.0f, 1.0f},
                       .middle = {0.0f, 1.0f, 0.0f, 1.0f},
                       .end = {0.0f, 0.0f, 1.0f, 0.0f},
                       .middle_at = 0.5f};
    settings.texture = TextureKind::streak;
    settings.blending = Blending::over;
    settings.streak_time = 0.25;
    ParticleSystem system = configured(settings);
    system.burst(1, {0.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f});
    system.step(0.125);
    const auto now = [&] { return system.view(); };
    EXPECT_EQ(now().texture, TextureKind::streak);
    EXPECT_EQ(now().blending, Blending::over);
    EXPECT_EQ(now().streak_end(0).x, 0.0f) << "not longer than the way since the release";
    system.step(0.375);
    EXPECT_EQ(now().streak_end(0).x, 0.5f);
    EXPECT_EQ(now().part_lived(0), 0.25f);
    EXPECT_EQ(now().size(0), 1.5f);
    EXPECT_NEAR(now().colour(0).red, 128, 2);
    EXPECT_NEAR(now().colour(0).green, 128, 2);
    system.step(1.4999);
    EXPECT_NEAR(now().size(0), 3.0, 0.001);
    EXPECT_EQ(now().colour(0), (Rgba{0, 0, 255, 0}));
}

} // namespace
} // namespace particles
