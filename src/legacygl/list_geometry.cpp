#include "legacygl/list_geometry.h"

#include <algorithm>
#include <utility>

namespace legacygl {

ListGeometry::ListGeometry(VertexBatch batch) : traits(batch), vertices(std::make_unique<Vertices>())
{
    drawable = std::all_of(batch.primitives.begin(), batch.primitives.end(),
                           [](const Primitive& p) { return p.begins && p.ends && p.mode <= GL_POLYGON; }) &&
               std::all_of(batch.unset_before.begin(), batch.unset_before.end(),
                           [](std::uint32_t count) { return count == 0; });
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i)
        if (batch.format.components[i] == 0)
            constants |= batch.attributes_set & (1u << i);
    if (drawable)
        make_runs(batch.primitives, vertices->runs, vertices->indices);
    run_count = static_cast<std::uint32_t>(vertices->runs.size());
    if (run_count > 0)
        first_run = vertices->runs.front();
    vertices->batch = std::move(batch);
}

} // namespace legacygl
