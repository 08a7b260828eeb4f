// The hashes below stand for every bit of every particle. They were computed once, natively; the same tests
// run with the sanitizers, without optimisation and as WebAssembly.

#include "particles/particle_system.h"

#include <gtest/gtest.h>

namespace particles {
namespace {

/// Bounces on the ground in air.
ParticleSettings sparking()
{
    ParticleSettings settings;
    settings.maximum_particles = 500;
    settings.release_count = 3;
    settings.release_interval = 0.04;
    settings.life = 1.1;
    settings.life_variance = 0.5;
    settings.velocity_variance = 10.0;
    settings.gravity = {0.0f, -9.81f, 0.0f};
    settings.air_resistance = 1.5;
    settings.planes[0].restitution = 0.45f;
    settings.planes[0].friction = 0.3f;
    settings.plane_count = 1;
    return settings;
}

/// Is blown against a slanted wall, where it sticks.
ParticleSettings painting()
{
    ParticleSettings settings;
    settings.maximum_particles = 700;
    settings.release_count = 10;
    settings.life = 3.0;
    settings.velocity = {0.0f, 5.0f, 0.0f};
    settings.velocity_variance = 2.5;
    settings.wind = {0.3f, 0.0f, -20.0f};
    settings.air_resistance = 0.8;
    settings.planes[0] = {
        .normal = {0.3f, 0.2f, 1.0f}, .point = {0.0f, 0.0f, -5.0f}, .response = ContactResponse::stick};
    settings.plane_count = 1;
    return settings;
}

/// Falls without air, from an area, and is recycled.
ParticleSettings raining()
{
    ParticleSettings settings;
    settings.maximum_particles = 400;
    settings.release_count = 7;
    settings.release_interval = 0.013;
    settings.life = 2.0;
    settings.position = {0.0f, 7.0f, 0.0f};
    settings.position_variance = {4.0f, 0.5f, 4.0f};
    settings.velocity_variance = 0.5;
    settings.gravity = {0.1f, -9.81f, 0.0f};
    settings.planes[0].response = ContactResponse::recycle;
    settings.plane_count = 1;
    return settings;
}

/// Bounces and slides among six slanted walls.
ParticleSettings boxed_in()
{
    ParticleSettings settings;
    settings.maximum_particles = 3'000;
    settings.release_count = 40;
    settings.life = 5.0;
    settings.life_variance = 0.9;
    settings.position = {0.0f, 1.0f, 0.0f};
    settings.position_variance = {0.5f, 0.25f, 1.0f};
    settings.velocity_variance = 8.0;
    settings.gravity = {0.0f, -9.81f, 0.0f};
    settings.wind = {1.0f, -0.5f, 2.0f};
    settings.air_resistance = 0.37;
    for (std::size_t i = 0; i < settings.planes.size(); ++i) {
        CollisionPlane& plane = settings.planes[i];
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        const auto axis = static_cast<glm::length_t>(i / 2);
        plane.normal = {0.1f, 0.07f, -0.03f};
        plane.normal[axis] += side;
        plane.point = {0.0f, 1.0f, 0.0f};
        plane.point[axis] -= 3.0f * side;
        plane.restitution = 0.8f;
        plane.friction = 0.3f;
    }
    settings.plane_count = 6;
    return settings;
}

/// Four hundred steps of 1 to 50 ms, with bursts in between and a source that moves.
void play(ParticleSystem& system, int steps = 400)
{
    for (int step = 0; step < steps; ++step) {
        if (step % 40 == 0) {
            EXPECT_TRUE(system.burst(30, {0.5f, 1.25f, -2.0f}, {1.0f, 2.0f, 0.3f}));
        }
        const glm::vec3 position = system.settings().position + glm::vec3{0.001f, 0.0f, 0.0f};
        EXPECT_TRUE(system.set_source(position, system.settings().velocity));
        EXPECT_TRUE(system.step(0.001 * (1 + step % 50)));
    }
}

struct Scenario
{
    const char* name;
    ParticleSettings settings;
    std::uint64_t hash;
};

const Scenario scenarios[] = {
    {"sparking", sparking(), 0x88e12ba1b7573736},
    {"painting", painting(), 0xf4d6b4c28b349224},
    {"raining", raining(), 0xc7f606d6d7ed4fa8},
    {"boxed in", boxed_in(), 0x281129502bf8665c},
};

TEST(Determinism, SameSeedSameHashOnEveryMachine)
{
    for (const Scenario& scenario : scenarios) {
        ParticleSystem system;
        ASSERT_EQ(system.configure(scenario.settings), "");
        system.restart(20'240'607);
        play(system);
        EXPECT_GT(system.live(), 50u);
        EXPECT_EQ(hash(system), scenario.hash) << scenario.name << std::hex << " 0x" << hash(system);
    }
}

TEST(Determinism, RestartingWithASeedReplaysIt)
{
    for (const Scenario& scenario : scenarios) {
        ParticleSystem first;
        ASSERT_EQ(first.configure(scenario.settings), "");
        first.restart(5);
        play(first);
        ParticleSystem second = first;
        second.restart(6);
        play(second);
        EXPECT_NE(hash(first), hash(second));
        ASSERT_EQ(second.configure(scenario.settings), "");
        second.restart(5);
        play(second);
        EXPECT_EQ(hash(first), hash(second)) << scenario.name;
        EXPECT_TRUE(first == second);
    }
}

TEST(Determinism, ACopyGoesOnAsTheOriginalDoes)
{
    ParticleSystem original;
    ASSERT_EQ(original.configure(sparking()), "");
    play(original, 40);
    original.burst(100, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    original.step(0.01); // in the middle of the burst
    EXPECT_FALSE(original.emitter().bursts().empty());
    ParticleSystem copy = original;
    EXPECT_TRUE(copy == original);
    play(original, 30);
    EXPECT_FALSE(copy == original);
    play(copy, 30);
    EXPECT_TRUE(copy == original);
    EXPECT_EQ(serialised(copy), serialised(original));
}

TEST(Determinism, HashIsFnv1aOfTheSerialisedValues)
{
    ParticleSystem system;
    ASSERT_EQ(system.configure(sparking()), "");
    play(system, 10);
    std::uint64_t expected_hash = 0xcbf29ce484222325;
    for (const char byte : serialised(system)) {
        expected_hash = (expected_hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    EXPECT_EQ(hash(system), expected_hash);
}

TEST(Determinism, HashTellsAnyChangeOfAnyQuantity)
{
    ParticleSystem system;
    ASSERT_EQ(system.configure(sparking()), "");
    play(system, 10);
    const std::uint64_t before = hash(system);
    ParticleSystem later = system;
    later.step(1e-6);
    EXPECT_NE(hash(later), before);
    ParticleSystem bursting = system;
    bursting.burst(1, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
    EXPECT_NE(hash(bursting), before);
}

} // namespace
} // namespace particles
