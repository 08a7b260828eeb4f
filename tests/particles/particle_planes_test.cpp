#include "one_particle.h"
#include "particles/presets.h"
#include "particles/random.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace particles {
namespace {

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
        plane.restitution = 1.0f;
        plane.friction = 0.0f;
    }
    for (const float restitution : {1.0f, 0.7f}) {
        settings.planes[0].restitution = restitution;
        ParticleSystem system = configured(settings);
        system.burst(200, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
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
            system.step(TICK);
            for (std::size_t i = 0; i < system.live(); ++i) {
                ASSERT_LE(energy(i), before[i] + 5e-5) << step; // rounding to float
                before[i] = energy(i);
            }
        }
        for (std::size_t i = 0; i < system.live(); ++i) {
            if (restitution == 1.0f) {
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
        if (view.z[i] == -5.0f) {
            EXPECT_EQ(view.velocity(i), glm::vec3(0.0f));
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
    settings.gravity = {0.0f, -10.0f, 0.0f};
    ParticleSystem system = configured(settings);
    system.burst(1, {0.0f, 0.8f, 0.0f}, {0.0f, 0.0f, 0.0f});
    system.step(0.39); // it takes 0.4 s
    EXPECT_EQ(system.live(), 1u);
    system.step(0.02);
    EXPECT_EQ(system.live(), 0u);
    EXPECT_EQ(system.counts().ended, 1u);
    system.burst(1, {0.0f, 0.8f, 0.0f}, {0.0f, 0.0f, 0.0f});
    system.step(0.5);
    EXPECT_EQ(system.counts().ended, 2u) << "recycled within the step that released it";
}

} // namespace
} // namespace particles
