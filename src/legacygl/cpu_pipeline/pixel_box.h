#pragma once

#include "legacygl/cpu_pipeline/shaded_vertex.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace legacygl {

/// Pixels from (x0, y0) up to but without (x1, y1).
struct PixelBox
{
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool empty() const { return x1 <= x0 || y1 <= y0; }
    bool overlaps(const PixelBox& other) const
    {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
    void include(const PixelBox& other)
    {
        *this = empty() ? other
                        : PixelBox{std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1),
                                   std::max(y1, other.y1)};
    }
    PixelBox within(const PixelBox& other) const
    {
        return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
                std::min(y1, other.y1)};
    }
};

/// How far coordinates count.
constexpr int FARTHEST = 1 << 20;
/// Holds all pixels.
constexpr PixelBox EVERYWHERE{-FARTHEST, -FARTHEST, FARTHEST, FARTHEST};

/// Returns a box that holds all pixels of a primitive that reaches beyond its vertices by at most so many
/// pixels.
inline PixelBox box_of(std::span<const ShadedVertex> vertices, float reach)
{
    constexpr float FAR = FARTHEST;
    glm::vec4 least(FAR), greatest(-FAR);
    for (const ShadedVertex& vertex : vertices) {
        for (int i = 0; i < 2; ++i) {
            least[i] = std::min(least[i], std::max(vertex.window[i], -FAR));
            greatest[i] = std::max(greatest[i], std::min(vertex.window[i], FAR));
        }
    }
    return {static_cast<int>(std::floor(least.x - reach)) - 1,
            static_cast<int>(std::floor(least.y - reach)) - 1,
            static_cast<int>(std::ceil(greatest.x + reach)) + 1,
            static_cast<int>(std::ceil(greatest.y + reach)) + 1};
}

} // namespace legacygl
