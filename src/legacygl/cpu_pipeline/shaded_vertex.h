#pragma once

#include "legacygl/vertex/format.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace legacygl {

/// What a vertex hands to its fragments.
struct Varyings
{
    std::array<glm::vec4, 2> color{};     ///< front, back; in [0, 1]
    std::array<glm::vec4, 2> secondary{}; ///< front, back
    std::array<glm::vec4, TEXTURE_UNIT_COUNT> texture{};
    float fog = 0;
};

/// Returns from + t (to - from), for everything; not clamped.
inline Varyings mix(const Varyings& from, const Varyings& to, float t)
{
    const auto between = [t](const glm::vec4& a, const glm::vec4& b) { return a + t * (b - a); };
    Varyings out;
    for (std::size_t i = 0; i < 2; ++i) {
        out.color[i] = between(from.color[i], to.color[i]);
        out.secondary[i] = between(from.secondary[i], to.secondary[i]);
    }
    for (std::size_t i = 0; i < TEXTURE_UNIT_COUNT; ++i) {
        out.texture[i] = between(from.texture[i], to.texture[i]);
    }
    out.fog = from.fog + t * (to.fog - from.fog);
    return out;
}

/// A vertex after transformation and lighting.
struct ShadedVertex
{
    glm::vec4 clip{};   ///< In clip coordinates.
    glm::vec4 window{}; ///< In pixels, depth in [0, 1]; w is 1 / clip.w.
    Varyings varyings;
    float point_size = 1;
    bool edge_flag = true;
    bool moved = false;        ///< The window coordinates are not what ES would make of the clip coordinates.
    std::uint32_t outside = 0; ///< Bit i: beyond plane i of the clip volume, see ClipVolume.
};

} // namespace legacygl
