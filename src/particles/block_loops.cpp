#include "particles/block_loops.h"

// Plain loops over arrays that do not overlap: both compilers turn them into SIMD instructions, which
// CMakeLists.txt allows for the web. Each result depends on its own particle only, so that neither the
// order nor the width of the instructions changes a bit.

namespace particles {

namespace {

float along(glm::vec3 normal, Vectors vectors, int i)
{
    return normal.x * vectors.x[i] + normal.y * vectors.y[i] + normal.z * vectors.z[i];
}

} // namespace

void move_block(float* __restrict positions, float* __restrict velocities, int count, AxisMotion motion)
{
    for (int i = 0; i < count; ++i) {
        const float velocity = velocities[i];
        positions[i] = positions[i] + (velocity * motion.reach + motion.way_gain);
        velocities[i] = velocity * motion.keep + motion.speed_gain;
    }
}

void move_block(float* __restrict positions, float* __restrict velocities, float* __restrict old_positions,
                float* __restrict old_velocities, int count, AxisMotion motion)
{
    for (int i = 0; i < count; ++i) {
        const float position = positions[i];
        const float velocity = velocities[i];
        old_positions[i] = position;
        old_velocities[i] = velocity;
        positions[i] = position + (velocity * motion.reach + motion.way_gain);
        velocities[i] = velocity * motion.keep + motion.speed_gain;
    }
}

bool age_block(float* __restrict ages, const float* __restrict lives, int count, float seconds)
{
    std::int32_t any_is_over = 0;
    for (int i = 0; i < count; ++i) {
        const float age = ages[i] + seconds;
        ages[i] = age;
        any_is_over |= age >= lives[i] ? 1 : 0;
    }
    return any_is_over != 0;
}

bool mark_outside(Vectors positions, std::int32_t* marks, int count, glm::vec3 normal, float offset,
                  bool adds)
{
    const std::int32_t kept = adds ? 1 : 0;
    std::int32_t any = 0;
    for (int i = 0; i < count; ++i) {
        const std::int32_t mark = (marks[i] & kept) | (along(normal, positions, i) < offset ? 1 : 0);
        marks[i] = mark;
        any |= mark;
    }
    return any != 0;
}

bool mark_turned(Vectors velocities_before, Vectors velocities_now, std::int32_t* marks, int count,
                 glm::vec3 normal)
{
    std::int32_t any = 0;
    for (int i = 0; i < count; ++i) {
        const std::int32_t came = along(normal, velocities_before, i) < 0.0f ? 1 : 0;
        const std::int32_t goes = along(normal, velocities_now, i) > 0.0f ? 1 : 0;
        const std::int32_t mark = marks[i] | (came & goes);
        marks[i] = mark;
        any |= mark;
    }
    return any != 0;
}

} // namespace particles
