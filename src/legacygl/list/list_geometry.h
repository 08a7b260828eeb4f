#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/vertex/assembler.h"
#include "legacygl/vertex/primitives.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace legacygl {

/// Vertices of a display list, and the backend's copy of them.
///
/// Has within itself what a call reads, and elsewhere the vertices: they build the copy again after a lost
/// context, are replayed one by one where a draw call would be wrong, and are what a capture notes.
struct ListGeometry
{
    explicit ListGeometry(VertexBatch vertices);

    /// Whether one draw call says all: every primitive begins and ends here, and no vertex needs a value
    /// that only the caller knows.
    bool drawable = false;
    /// Attributes that were set but are the same for every vertex, as bits of Attribute.
    std::uint32_t constants = 0;
    GeometryObject object; ///< The backend's copy, made at the first draw.
    std::uint32_t run_count = 0;
    std::uint32_t runs_of_one_color = 0; ///< Of primitives_of_one_color(), which come first.
    DrawRun first_run{};
    BatchTraits traits; ///< The vertices'.

    struct Vertices
    {
        VertexBatch batch;
        std::vector<std::uint32_t> indices;
        std::vector<DrawRun> runs;
    };
    std::unique_ptr<Vertices> vertices; ///< Never null.

    std::span<const DrawRun> runs() const
    {
        return run_count > 1 ? std::span(vertices->runs) : std::span(&first_run, run_count);
    }
};

} // namespace legacygl
