#pragma once

#include "particles/colour_table.h"
#include "particles/settings.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

namespace particles {

/// Shows the living particles of a system, for drawing; copies nothing, costs nothing to copy.
/// In no particular order. Valid until the system is next changed, moved or destroyed. Metres, seconds.
struct ParticleView
{
    std::span<const float> x; ///< positions; all these spans are count() long
    std::span<const float> y;
    std::span<const float> z;
    std::span<const float> velocity_x;
    std::span<const float> velocity_y;
    std::span<const float> velocity_z;
    std::span<const float> age;
    std::span<const float> life;       ///< the age at which it is over; more than its age
    std::span<const Rgba> colour_ramp; ///< over a life, in equal steps; 256
    SizeRamp size_ramp;
    TextureKind texture = TextureKind::soft_dot;
    Blending blending = Blending::additive;
    float streak_time = 0.0f;

    std::size_t count() const { return x.size(); }
    glm::vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
    glm::vec3 velocity(std::size_t i) const { return {velocity_x[i], velocity_y[i], velocity_z[i]}; }

    /// Returns the part of its life that is over, in [0, 1].
    float part_lived(std::size_t i) const { return age[i] / life[i]; }

    /// Returns its colour now.
    Rgba colour(std::size_t i) const
    {
        const float step = part_lived(i) * static_cast<float>(colour_ramp.size() - 1) + 0.5f;
        return colour_ramp[static_cast<std::size_t>(step)];
    }

    /// Returns a dot's diameter or a streak's width now, in metres.
    float size(std::size_t i) const
    {
        return size_ramp.start + (size_ramp.end - size_ramp.start) * part_lived(i);
    }

    /// Returns where its streak ends: the streak goes from here to position(i). A particle at rest, or just
    /// released, has none: both are the same then. Just after a bounce, it may end behind the plane.
    glm::vec3 streak_end(std::size_t i) const
    {
        const float time = std::min(streak_time, age[i]);
        return position(i) - velocity(i) * time;
    }
};

} // namespace particles
