#pragma once

#include "legacygl/matrix.h"
#include "legacygl/raster/clipping.h"
#include "legacygl/state/transform.h"
#include "legacygl/vertex_assembler.h"

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
    std::uint32_t of(std::uint32_t vertex) const
    {
        const float* values =
            batch_.vertices.data() + static_cast<std::size_t>(vertex) * batch_.format.floats();
        glm::vec4 position = {0, 0, 0, 1};
        for (int c = 0; c < batch_.format.components[0]; ++c)
            position[c] = values[c];
        return volume_.outside(projection_modelview_.transform(position));
    }

    /// Returns whether one of the vertices is beyond one of the planes.
    bool any(std::uint32_t first, std::uint32_t count, std::uint32_t planes) const
    {
        for (std::uint32_t vertex = first; vertex < first + count; ++vertex)
            if (of(vertex) & planes)
                return true;
        return false;
    }

private:
    const VertexBatch& batch_;
    const ClipVolume volume_;
    const Matrix projection_modelview_;
};

} // namespace legacygl
