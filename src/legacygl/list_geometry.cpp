#include "legacygl/list_geometry.h"

#include <algorithm>
#include <utility>

namespace legacygl {

ListGeometry::ListGeometry(VertexBatch vertices) : batch(std::move(vertices))
{
    drawable = std::all_of(batch.primitives.begin(), batch.primitives.end(),
                           [](const Primitive& p) { return p.begins && p.ends && p.mode <= GL_POLYGON; }) &&
               std::all_of(batch.unset_before.begin(), batch.unset_before.end(),
                           [](std::uint32_t count) { return count == 0; });
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i)
        if (batch.format.components[i] == 0)
            constants |= batch.attributes_set & (1u << i);
    if (!drawable)
        return;
    const std::size_t of_one_color = batch.primitives_of_one_color();
    const std::span<const Primitive> primitives = batch.primitives;
    std::vector<DrawRun> others;
    make_runs(primitives.first(of_one_color), runs, indices);
    make_runs(primitives.subspan(of_one_color), others, indices);
    runs_of_one_color = runs.size();
    runs.insert(runs.end(), others.begin(), others.end());
}

} // namespace legacygl
