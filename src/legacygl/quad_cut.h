#pragma once

#include "legacygl/raster/clipping.h"
#include "legacygl/state/state.h"
#include "legacygl/vertex_assembler.h"

#include <cstddef>
#include <optional>

namespace legacygl {

/// Knows along which diagonal Mesa cuts the quads of a batch that is drawn at once.
///
/// OpenGL leaves the diagonal open (OpenGL 1.5, 2.6.1), but it is seen where a quad's corners have different
/// colours. Mesa cuts from the first corner where no vertex of neighbouring quads lies outside of the view
/// volume and nothing is flat, and between the second and the fourth corner else, and where quads come by
/// index.
class QuadCut
{
public:
    /// flat: whether fragments take the colour of one vertex, which differs from the others'.
    QuadCut(const State& state, const VertexBatch& batch, bool flat);

    /// Returns whether the quads of primitive i of the batch are cut from their first corner.
    bool from_first(std::size_t i);

private:
    bool all_inside(std::size_t first, std::size_t end);

    const State& state_;
    const VertexBatch& batch_;
    const bool possible_;
    std::optional<ClipVolume> volume_;
    Matrix projection_modelview_;
    std::size_t known_until_ = 0; ///< The end of the neighbouring quads that answer_ is about.
    bool answer_ = false;
};

} // namespace legacygl
