#pragma once

#include "particles/settings.h"

#include <span>
#include <string_view>

namespace particles {

/// Names the presets: the six that Lab 2's particle system shows, in its order, and two for hits on the tank.
enum class PresetName : std::uint8_t
{
    explosion,
    fountain,
    space,
    paint,
    bounce,
    box,
    sparks,
    shower,
};

/// A named choice of settings, around the world's origin, the ground being y = 0; moved() puts it elsewhere.
struct Preset
{
    PresetName name;
    std::string_view id; ///< the name in links and on the page
    std::string_view title;
    int burst_count; ///< > 0: it does not release by itself; hand this to burst()
    ParticleSettings settings;
};

/// Returns the table of presets, in the order of PresetName.
std::span<const Preset> presets();

/// Returns the row of a preset.
const Preset& preset(PresetName name);

} // namespace particles
