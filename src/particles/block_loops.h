#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace particles {

/// How many particles the loops below take at a time, at most: their values stay in the nearest cache.
constexpr std::size_t BLOCK_SIZE = 256;

/// What one step does to the positions and velocities along one axis; see Flight.
struct AxisMotion
{
    float keep;
    float reach;
    float speed_gain; ///< acceleration * reach, m/s
    float way_gain;   ///< acceleration * fall, m
};

/// Points at the values of some particles along each axis.
struct Vectors
{
    const float* x;
    const float* y;
    const float* z;
};

/// Moves `count` particles along one axis.
void move_block(float* __restrict positions, float* __restrict velocities, int count, AxisMotion motion);

/// Does the same, having copied the values to old_positions and old_velocities.
void move_block(float* __restrict positions, float* __restrict velocities, float* __restrict old_positions,
                float* __restrict old_velocities, int count, AxisMotion motion);

/// Adds to `count` ages and returns whether any has reached its life.
bool age_block(float* __restrict ages, const float* __restrict lives, int count, float seconds);

/// Sets the marks of those of `count` particles to 1 for which dot(normal, position) < offset. The others'
/// become 0 or, with `adds`, stay. Returns whether any mark is set.
bool mark_outside(Vectors positions, std::int32_t* marks, int count, glm::vec3 normal, float offset,
                  bool adds);

/// Sets the marks of those of `count` particles to 1 that moved against the normal before and move along it
/// now, and leaves the others'. Returns whether any mark is set.
bool mark_turned(Vectors velocities_before, Vectors velocities_now, std::int32_t* marks, int count,
                 glm::vec3 normal);

} // namespace particles
