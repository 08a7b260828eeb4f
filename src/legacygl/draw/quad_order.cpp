#include "legacygl/draw/quad_order.h"

namespace legacygl {
namespace {

/// Returns whether Mesa's pipeline takes all polygons.
bool takes_polygons(const State& state)
{
    const RasterState& raster = state.raster;
    const bool two_side = state.lighting.enabled && state.lighting.two_side;
    return raster.unfilled() || raster.polygon_stipple.enabled || raster.offsets_in_pipeline() ||
           (two_side && (raster.line_smooth || raster.point_smooth || raster.line_stipple.enabled));
}

} // namespace

MesaQuadOrders::MesaQuadOrders(const State& state, const VertexBatch& batch,
                               std::span<const Primitive> primitives, bool flat, bool in_list)
    : state_(state), batch_(batch), primitives_(primitives),
      from_first_(!flat && !in_list && state.raster.provoking_vertex != GL_FIRST_VERTEX_CONVENTION),
      emitted_(!takes_polygons(state))
{}

QuadOrder MesaQuadOrders::of(std::size_t i)
{
    const GLenum mode = primitives_[i].mode;
    if (mode != GL_QUADS && mode != GL_QUAD_STRIP) {
        return {};
    }
    if (!emitted_) {
        return {false, false};
    }
    if (i >= known_until_) {
        known_until_ = i + 1;
        // Mesa takes neighbouring quads together.
        while (mode == GL_QUADS && known_until_ < primitives_.size() &&
               primitives_[known_until_].mode == GL_QUADS && !primitives_[known_until_].indexed) {
            ++known_until_;
        }
        inside_ = all_inside(i, known_until_);
    }
    return {inside_ && from_first_ && !primitives_[i].indexed, inside_};
}

bool MesaQuadOrders::all_inside(std::size_t first, std::size_t end)
{
    if (!outcodes_) {
        outcodes_.emplace(state_.transform, batch_);
    }
    for (std::size_t p = first; p < end; ++p) {
        const Primitive& quads = primitives_[p];
        const std::uint32_t size = quads.mode == GL_QUADS ? 4 : 2;
        if (outcodes_->any(quads.first, quads.count / size * size, ClipVolume::ALL)) {
            return false;
        }
    }
    return true;
}

} // namespace legacygl
