#include "particles/particle_system.h"

#include "particles/presets.h"
#include "particles/random.h"

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace particles {
namespace {

constexpr double tick = 1.0 / 60.0;

/// One particle that can be told where it must be.
ParticleSettings one_particle()
{
    ParticleSettings settings;
    settings.maximum_particles = 1;
    settings.releases = false;
    settings.release_interval = 0.001;
    settings.life = 60.0;
    return settings;
}

ParticleSystem configured(const ParticleSettings& settings)
{
    ParticleSystem system;
    EXPECT_EQ(system.configure(settings), "");
    return system;
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance)
{
    EXPECT_NEAR(glm::length(actual - expected), 0.0, tolerance)
        << actual.x << " " << actual.y << " " << actual.z << " instead of " << expected.x << " " << expected.y
        << " " << expected.z;
}

TEST(ParticleSystem, FallsAsGalileoSays)
{
    ParticleSettings settings = one_particle();
    settings.gravity = {1.0F, -9.8125F, 0.5F};
    for (const int steps : {1, 2, 60, 1000}) {
        ParticleSystem system = configured(settings);
        system.burst(1, {1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, -6.0F});
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
    settings.gravity = {0.0F, -9.8125F, 0.0F};
    settings.wind = {3.0F, 0.0F, 1.0F};
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
    settings.wind = {3.0F, 0.0F, 1.0F};
    settings.air_resistance = 5.0;
    ParticleSystem system = configured(settings);
    system.burst(1, {0.0F, 0.0F, 0.0F}, {0.0F, 50.0F, 0.0F});
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
    at_once.burst(50, {0.0F, 3.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    in_parts.burst(50, {0.0F, 3.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    at_once.step(2.0);
    for (int i = 0; i < 120; ++i) {
        in_parts.step(tick);
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
        settings.velocity = {0.0F, 1.0F, 0.0F};
        ParticleSystem system = configured(settings);
        Random random(1, static_cast<std::uint64_t>(response));
        std::uint64_t asked = 0;
        while (system.counts().released < 350'000 && asked < 20'000'000) {
            const std::uint64_t before = system.counts().released + system.counts().refused;
            if (random.uniform() < 0.2) {
                ASSERT_TRUE(system.burst(static_cast<int>(random.uniform() * 300.0), {0.0F, 1.0F, 0.0F},
                                         {1.0F, 1.0F, 1.0F}));
            }
            const double choice = random.uniform();
            ASSERT_TRUE(system.step(choice < 0.1 ? 0.0 : choice < 0.95 ? tick * choice : choice));
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
        system.burst(1000, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
        system.step(0.1);
        EXPECT_EQ(system.live(), 777u) << "every place can be had again";
    }
}

TEST(ParticleSystem, KeepsWhoIsThereWhenItIsFull)
{
    ParticleSettings settings = one_particle();
    settings.maximum_particles = 10;
    ParticleSystem system = configured(settings);
    system.burst(10, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    system.step(tick);
    system.burst(10, {2.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    system.step(tick);
    EXPECT_EQ(system.live(), 10u);
    EXPECT_EQ(system.counts().refused, 10u);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(system.view().position(i).x, 1.0F);
    }
}

/// The settings that push all limits at once.
ParticleSettings extreme()
{
    ParticleSettings settings;
    settings.maximum_particles = 300;
    settings.release_count = 50;
    settings.life = longest_life;
    settings.life_variance = 1.0;
    settings.position = {10'000.0F, -10'000.0F, 10'000.0F};
    settings.position_variance = {10'000.0F, 0.0F, 10'000.0F};
    settings.velocity = {-1000.0F, 1000.0F, 1000.0F};
    settings.velocity_variance = 1000.0;
    settings.gravity = {1000.0F, -1000.0F, 1000.0F};
    settings.wind = {1000.0F, 1000.0F, -1000.0F};
    settings.planes = {
        CollisionPlane{.normal = {1000.0F, 1000.0F, 0.0F}, .point = {10'000.0F, 0.0F, 0.0F}},
        CollisionPlane{.normal = {-0.001F, 0.0F, 0.0F}, .restitution = 1.0F, .friction = 10.0F},
        CollisionPlane{.normal = {0.0F, -1.0F, 1.0F}, .restitution = 0.0F}};
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
                            tick,
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
    EXPECT_FALSE(system.burst(100, {0.0F, nan, 0.0F}, {0.0F, 0.0F, 0.0F}));
    EXPECT_FALSE(system.burst(100, {0.0F, 0.0F, 0.0F}, {1e30F, 0.0F, 0.0F}));
    EXPECT_FALSE(system.burst(-1, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}));
    EXPECT_FALSE(system.set_source({nan, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}));
    EXPECT_TRUE(system.burst(0, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}));
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
    none.burst(10, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    EXPECT_TRUE(none.step(1.0));
    EXPECT_EQ(none.live(), 0u);
    EXPECT_EQ(none.capacity(), 0u);
    EXPECT_FALSE(none.is_active());

    ParticleSettings settings;
    settings.life = 0.0;
    ParticleSystem lifeless = configured(settings);
    lifeless.burst(10, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
    EXPECT_TRUE(lifeless.step(1.0));
    EXPECT_EQ(lifeless.live(), 0u);
    EXPECT_EQ(lifeless.counts().refused, 0u);
    EXPECT_EQ(lifeless.counts().ended, lifeless.counts().released);
    EXPECT_FALSE(lifeless.is_active());
}

TEST(ParticleSystem, HoldsAMillionParticles)
{
    ParticleSettings settings = preset(PresetName::bounce).settings;
    settings.maximum_particles = most_places;
    settings.release_count = most_places;
    settings.release_interval = 1.0;
    ParticleSystem system = configured(settings);
    system.step(tick);
    EXPECT_EQ(system.live(), static_cast<std::size_t>(most_places));
    EXPECT_EQ(system.free(), 0u);
    system.step(tick);
    expect_finite(system);
    system.set_releasing(false);
    system.step(5.0);
    EXPECT_EQ(system.live(), 0u);
}

TEST(ParticleSystem, StepCostsWhatLivesNotWhatThereArePlacesFor)
{
    ParticleSettings settings = one_particle();
    settings.maximum_particles = most_places;
    ParticleSystem system = configured(settings);
    system.burst(3, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
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
                system.burst(40, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F});
            }
            system.step(tick);
        }
        EXPECT_TRUE(system.is_active());
        system.set_releasing(false);
        const int life = static_cast<int>((row.settings.life + row.settings.release_interval) * 60.0) + 1;
        for (int i = 0; i < life; ++i) {
            system.step(tick);
        }
        EXPECT_EQ(system.live(), 0u) << row.id;
        EXPECT_EQ(system.counts().ended, system.counts().released);
        EXPECT_FALSE(system.is_active());
    }
}

TEST(ParticleSystem, NothingSinksThroughThePlanesAtAnyStep)
{
    Random random(1, 0);
    for (int run = 0; run < 60; ++run) {
        ParticleSettings settings = preset(run % 2 == 0 ? PresetName::box : PresetName::bounce).settings;
        settings.maximum_particles = 400;
        settings.velocity_variance = 60.0 * random.uniform();
        settings.air_resistance = run % 3 == 0 ? 0.0 : random.uniform() * 3.0;
        settings.gravity = glm::vec3{random.in_ball() * 50.0};
        for (CollisionPlane& plane : settings.planes) {
            plane.restitution = static_cast<float>(random.uniform());
            plane.friction = static_cast<float>(random.uniform());
            plane.normal += glm::vec3{random.in_ball() * 0.2};
        }
        ParticleSystem system = configured(settings);
        for (int step = 0; step < 20; ++step) {
            system.step(std::exp(random.uniform() * 12.0 - 9.0)); // 0.0001 to 20 s
            for (const CollisionPlane& plane : settings.used_planes()) {
                const Wall wall = wall_of(plane);
                for (std::size_t i = 0; i < system.live(); ++i) {
                    const glm::dvec3 position{system.view().position(i)};
                    ASSERT_GE(glm::dot(wall.normal, position) - wall.offset,
                              -2e-6 * (1.0 + glm::length(position)));
                }
            }
        }
    }
}

TEST(ParticleSystem, EnergyOfBouncingParticlesNeverGrows)
{
    ParticleSettings settings = preset(PresetName::box).settings;
    settings.releases = false;
    settings.life = 60.0;
    settings.maximum_particles = 200;
    for (CollisionPlane& plane : settings.planes) {
        plane.restitution = 1.0F;
        plane.friction = 0.0F;
    }
    for (const float restitution : {1.0F, 0.7F}) {
        settings.planes[0].restitution = restitution;
        ParticleSystem system = configured(settings);
        system.burst(200, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 0.0F});
        system.step(0.1);
        const auto energy = [&](std::size_t i) {
            const glm::dvec3 velocity{system.view().velocity(i)};
            return glm::dot(velocity, velocity) / 2.0 +
                   -static_cast<double>(settings.gravity.y) * static_cast<double>(system.view().y[i]);
        };
        std::vector<double> first;
        for (std::size_t i = 0; i < system.live(); ++i) {
            first.push_back(energy(i));
        }
        std::vector<double> before = first;
        for (int step = 0; step < 1000; ++step) {
            system.step(tick);
            for (std::size_t i = 0; i < system.live(); ++i) {
                ASSERT_LE(energy(i), before[i] + 5e-5) << step; // rounding to float
                before[i] = energy(i);
            }
        }
        for (std::size_t i = 0; i < system.live(); ++i) {
            if (restitution == 1.0F) {
                EXPECT_NEAR(before[i], first[i], 0.002 * first[i] + 0.01) << "nor is any lost without a loss";
            }
            EXPECT_LE(before[i], first[i] + 0.01);
        }
    }
}

TEST(ParticleSystem, StuckParticlesStayUntilTheirLifeIsOver)
{
    ParticleSettings settings = preset(PresetName::paint).settings;
    settings.releases = false;
    settings.maximum_particles = 200;
    settings.life_variance = 0.5;
    ParticleSystem system = configured(settings);
    system.burst(200, settings.position, settings.velocity);
    system.step(1.4); // the first of them end at 1.5
    std::vector<glm::vec3> places;
    const ParticleView view = system.view();
    for (std::size_t i = 0; i < view.count(); ++i) {
        if (view.z[i] == -5.0F) {
            EXPECT_EQ(view.velocity(i), glm::vec3(0.0F));
            EXPECT_EQ(view.streak_end(i), view.position(i));
            places.push_back(view.position(i));
        }
    }
    EXPECT_GT(places.size(), 100u);
    system.step(0.05);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(system.view().position(i), places[i]) << "the stuck are the first, and none has ended yet";
    }
    system.step(3.0);
    EXPECT_EQ(system.live(), 0u);
}

TEST(ParticleSystem, RecyclingFreesThePlaceAtOnce)
{
    ParticleSettings settings = one_particle();
    settings.planes[0].response = ContactResponse::recycle;
    settings.plane_count = 1;
    settings.gravity = {0.0F, -10.0F, 0.0F};
    ParticleSystem system = configured(settings);
    system.burst(1, {0.0F, 0.8F, 0.0F}, {0.0F, 0.0F, 0.0F});
    system.step(0.39); // it takes 0.4 s
    EXPECT_EQ(system.live(), 1u);
    system.step(0.02);
    EXPECT_EQ(system.live(), 0u);
    EXPECT_EQ(system.counts().ended, 1u);
    system.burst(1, {0.0F, 0.8F, 0.0F}, {0.0F, 0.0F, 0.0F});
    system.step(0.5);
    EXPECT_EQ(system.counts().ended, 2u) << "recycled within the step that released it";
}

TEST(ParticleSystem, VariancesAreRangesAroundTheSettings)
{
    ParticleSettings settings;
    settings.maximum_particles = 5'000;
    settings.releases = false;
    settings.life = 10.0;
    settings.life_variance = 0.25;
    settings.position_variance = {1.0F, 0.0F, 3.0F};
    settings.velocity_variance = 4.0;
    ParticleSystem system = configured(settings);
    system.burst(5'000, {10.0F, 20.0F, 30.0F}, {1.0F, 2.0F, 3.0F});
    system.step(0.05);
    ASSERT_EQ(system.live(), 5'000u);
    glm::vec3 lowest{1e9F};
    glm::vec3 highest{-1e9F};
    float fastest = 0.0F;
    for (std::size_t i = 0; i < system.live(); ++i) {
        const ParticleView view = system.view();
        EXPECT_TRUE(view.life[i] > 7.5F && view.life[i] <= 10.0F);
        const glm::vec3 begin = view.position(i) - view.velocity(i) * view.age[i];
        lowest = glm::min(lowest, begin);
        highest = glm::max(highest, begin);
        fastest = std::max(fastest, glm::length(view.velocity(i) - glm::vec3{1.0F, 2.0F, 3.0F}));
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
    system.burst(8, {0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F});
    system.step(0.5);
    settings.gravity = {0.0F, -2.0F, 0.0F};
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
    system.step(tick);
    EXPECT_EQ(system.counts().released, 1u);
    system.set_releasing(false);
    system.step(1.0);
    system.set_releasing(true);
    system.set_releasing(true);
    system.step(tick);
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
    EXPECT_TRUE(system.set_source({5.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}));
    system.step(0.1);
    ASSERT_EQ(system.live(), 2u);
    EXPECT_EQ(system.view().position(0).x, 0.0F);
    EXPECT_EQ(system.view().position(1).x, 5.0F);
    EXPECT_EQ(system.settings().position.x, 5.0F);
}

TEST(ParticleView, FollowsTheRampsOverALife)
{
    ParticleSettings settings = one_particle();
    settings.life = 2.0;
    settings.size = {1.0F, 3.0F};
    settings.colour = {.start = {1.0F, 0.0F, 0.0F, 1.0F},
                       .middle = {0.0F, 1.0F, 0.0F, 1.0F},
                       .end = {0.0F, 0.0F, 1.0F, 0.0F},
                       .middle_at = 0.5F};
    settings.texture = TextureKind::streak;
    settings.blending = Blending::over;
    settings.streak_time = 0.25;
    ParticleSystem system = configured(settings);
    system.burst(1, {0.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F});
    system.step(0.125);
    const auto now = [&] { return system.view(); };
    EXPECT_EQ(now().texture, TextureKind::streak);
    EXPECT_EQ(now().blending, Blending::over);
    EXPECT_EQ(now().streak_end(0).x, 0.0F) << "not longer than the way since the release";
    system.step(0.375);
    EXPECT_EQ(now().streak_end(0).x, 0.5F);
    EXPECT_EQ(now().part_lived(0), 0.25F);
    EXPECT_EQ(now().size(0), 1.5F);
    EXPECT_NEAR(now().colour(0).red, 128, 2);
    EXPECT_NEAR(now().colour(0).green, 128, 2);
    system.step(1.4999);
    EXPECT_NEAR(now().size(0), 3.0, 0.001);
    EXPECT_EQ(now().colour(0), (Rgba{0, 0, 255, 0}));
}

} // namespace
} // namespace particles
