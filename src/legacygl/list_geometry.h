#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/primitives.h"
#include "legacygl/vertex_assembler.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace legacygl {

/// Vertices of a display list, and the backend's copy of them.
///
/// Keeps the vertices themselves: to build the copy again after a lost context, to replay them one by one
/// where a draw call would be wrong, and for capture.
struct ListGeometry
{
    explicit ListGeometry(VertexBatch vertices);

    /// Whether one draw call says all: every primitive begins and ends here, and no vertex needs a value
    /// that only the caller knows.
    bool drawable = false;
    /// Attributes that were set but are the same for every vertex, as bits of Attribute.
    std::uint32_t constants = 0;
    GeometryObject object; ///< The backend's copy, made at the first draw.
    std::vector<DrawRun> runs;
    std::size_t runs_of_one_color = 0; ///< Of primitives_of_one_color(), at the beginning of runs.
    VertexBatch batch;                 ///< Behind what else a call reads, and with what it reads first.
    std::vector<std::uint32_t> indices;
};

} // namespace legacygl
