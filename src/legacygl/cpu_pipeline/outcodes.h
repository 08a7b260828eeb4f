#pragma once

#include "legacygl/cpu_pipeline/clipping.h"
#include "legacygl/state/matrix.h"
#include "legacygl/state/transform.h"
#include "legacygl/vertex/assembler.h"

#include <glm/vec2.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace legacygl {

/// Tells which planes of the clip volume the vertices of a batch are beyond.
class Outcodes
{
public:
    Outcodes(const TransformState& transform, const VertexBatch& batch)
        : batch_(batch), volume_(transform),
          projection_modelview_(Matrix::product(transform.projection.top(), transform.modelview.top()))
    {}

    /// Returns them as bits, see ClipVolume.
    std::uint32_t of(std::uint32_t vertex) const { return volume_.outside(clip(vertex)); }

    /// Returns whether one of the vertices is beyond one of the planes.
    bool any(std::uint32_t first, std::uint32_t count, std::uint32_t planes) const
    {
        for (std::uint32_t vertex = first; vertex < first + count; ++vertex) {
            if (of(vertex) & planes) {
                return true;
            }
        }
        return false;
    }

    /// Returns whether two vertices that follow one another lie on the same side of the view, or less than
    /// half a pixel of a viewport of this size away: a line between them then has pixels beyond the viewport.
    bool any_along_a_side(glm::vec2 viewport_size) const
    {
        const auto sides = [&](std::uint32_t vertex) {
            const glm::vec4 p = clip(vertex);
            std::uint32_t mask = 0;
            for (int i = 0; i < 2; ++i) {
                const float reach = p.w / viewport_size[i];
                mask |= static_cast<std::uint32_t>(std::fabs(p[i] - p.w) < reach) << (2 * i);
                mask |= static_cast<std::uint32_t>(std::fabs(p[i] + p.w) < reach) << (2 * i + 1);
            }
            return mask;
        };
        std::uint32_t last = 0;
        for (std::uint32_t vertex = 0; vertex < batch_.vertex_count; ++vertex) {
            const std::uint32_t now = sides(vertex);
            if (last & now) {
                return true;
            }
            last = now;
        }
        return false;
    }

private:
    glm::vec4 clip(std::uint32_t vertex) const
    {
        const float* values =
            batch_.vertices.data() + static_cast<std::size_t>(vertex) * batch_.format.floats();
        glm::vec4 position = {0, 0, 0, 1};
        for (int c = 0; c < batch_.format.components[0]; ++c) {
            position[c] = values[c];
        }
        return projection_modelview_.transform(position);
    }

    const VertexBatch& batch_;
    const ClipVolume volume_;
    const Matrix projection_modelview_;
};

} // namespace legacygl
