#include "legacygl/list/list_geometry.h"

#include <algorithm>
#include <utility>

namespace legacygl {

ListGeometry::ListGeometry(VertexBatch batch) : traits(batch), vertices(std::make_unique<Vertices>())
{
    drawable = std::all_of(batch.primitives.begin(), batch.primitives.end(),
                           [](const Primitive& p) { return p.begins && p.ends && p.mode <= GL_POLYGON; }) &&
               std::all_of(batch.unset_before.begin(), batch.unset_before.end(),
                           [](std::uint32_t count) { return count == 0; });
    for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
        if (batch.format.components[i] == 0) {
            constants |= batch.attributes_set & (1u << i);
        }
    }
    if (drawable) {
        const std::size_t of_one_color = batch.primitives_of_one_color();
        const std::span<const Primitive> primitives = batch.primitives;
        std::vector<DrawRun>& runs_made = vertices->runs;
        std::vector<DrawRun> others;
        make_runs(primitives.first(of_one_color), runs_made, vertices->indices);
        make_runs(primitives.subspan(of_one_color), others, vertices->indices);
        runs_of_one_color = static_cast<std::uint32_t>(runs_made.size());
        runs_made.insert(runs_made.end(), others.begin(), others.end());
        run_count = static_cast<std::uint32_t>(runs_made.size());
        if (run_count > 0) {
            first_run = runs_made.front();
        }
    }
    vertices->batch = std::move(batch);
}

} // namespace legacygl
