#pragma once

#include "particles/particle_system.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace particles {

/// A frame of the display, in seconds.
inline constexpr double TICK = 1.0 / 60.0;

/// One particle that can be told where it must be.
inline ParticleSettings one_particle()
{
    ParticleSettings settings;
    settings.maximum_particles = 1;
    settings.releases = false;
    settings.release_interval = 0.001;
    settings.life = 60.0;
    return settings;
}

/// A system with settings that it has to take.
inline ParticleSystem configured(const ParticleSettings& settings)
{
    ParticleSystem system;
    EXPECT_EQ(system.configure(settings), "");
    return system;
}

/// Expects a point within `tolerance` of another.
inline void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance)
{
    EXPECT_NEAR(glm::length(actual - expected), 0.0, tolerance)
        << actual.x << " " << actual.y << " " << actual.z << " instead of " << expected.x << " " << expected.y
        << " " << expected.z;
}

} // namespace particles
