#include "legacygl/quad_cut.h"

namespace legacygl {

QuadCut::QuadCut(const State& state, const VertexBatch& batch, bool flat)
    : state_(state), batch_(batch), possible_(!flat && !state.raster.polygon_stipple.enabled)
{}

bool QuadCut::from_first(std::size_t i)
{
    if (!possible_ || batch_.primitives[i].indexed)
        return false;
    if (i < known_until_)
        return answer_;
    known_until_ = i + 1;
    while (known_until_ < batch_.primitives.size() && batch_.primitives[known_until_].mode == GL_QUADS &&
           !batch_.primitives[known_until_].indexed)
        ++known_until_;
    answer_ = all_inside(i, known_until_);
    return answer_;
}

bool QuadCut::all_inside(std::size_t first, std::size_t end)
{
    if (!volume_) {
        volume_.emplace(state_.transform);
        projection_modelview_ =
            Matrix::product(state_.transform.projection.top(), state_.transform.modelview.top());
    }
    const auto floats = static_cast<std::size_t>(batch_.format.floats());
    const int components = batch_.format.components[0];
    for (std::size_t p = first; p < end; ++p) {
        const Primitive& quads = batch_.primitives[p];
        for (std::uint32_t v = quads.first; v < quads.first + quads.count / 4 * 4; ++v) {
            glm::vec4 position = {0, 0, 0, 1};
            for (int c = 0; c < components; ++c)
                position[c] = batch_.vertices[v * floats + static_cast<std::size_t>(c)];
            if (volume_->outside(projection_modelview_.transform(position)) != 0)
                return false;
        }
    }
    return true;
}

} // namespace legacygl
