#pragma once

#include <cstdint>

namespace legacygl::change {

/// What a command changed, as bits, so that the next draw looks at it again.
enum Bits : std::uint32_t
{
    matrices = 1, ///< Modelview and projection; those of textures belong to texturing.
    lighting = 2,
    texturing = 4,
    pipeline = 8,
    fragments = 16,
    everything = ~0u
};

} // namespace legacygl::change
