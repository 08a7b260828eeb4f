#include "legacygl/draw/es_limits.h"

#include "legacygl/cpu_pipeline/outcodes.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace legacygl {
namespace {

/// Returns whether no pixel of the target is outside the viewport. ES may cut points and lines off at the
/// viewport's edge, and OpenGL does not.
bool viewport_holds_target(const State& state, const Backend& backend)
{
    const std::array<GLint, 4>& v = state.transform.viewport;
    return v[0] <= 0 && v[1] <= 0 && v[0] + v[2] >= backend.target_width &&
           v[1] + v[3] >= backend.target_height;
}

/// Returns whether ES would draw less of the lines of a batch than OpenGL does: where they reach beyond the
/// viewport, or where it does not cut those that leave the view.
bool loses_lines(const State& state, Backend& backend, const VertexBatch& batch, bool beyond_viewport)
{
    if (!beyond_viewport && backend.clips_lines()) {
        return false;
    }
    const Outcodes outcodes(state.transform, batch);
    const std::array<GLint, 4>& v = state.transform.viewport;
    if (beyond_viewport && outcodes.any_along_a_side({v[2], v[3]})) {
        return true;
    }
    return !backend.clips_lines() && outcodes.any(0, batch.vertex_count, ClipVolume::SIDES);
}

} // namespace

std::optional<RasterWork> raster_work(const State& state, Backend& backend, const BatchTraits& traits,
                                      const VertexBatch& batch)
{
    const RasterState& raster = state.raster;
    const float line_width = std::floor(raster.line_width + 0.5f);
    const bool beyond_viewport = !viewport_holds_target(state, backend);
    const RasterWork work{raster.unfilled() || raster.offsets_in_pipeline(),
                          line_width > backend.maximum_line_width, raster.line_smooth, raster.point_smooth,
                          beyond_viewport};
    const bool own_materials = state.lighting.enabled && traits.changes_materials;
    const bool all =
        state.transform.clips() || own_materials || state.fragment.effective_logic_op() != GL_COPY ||
        (raster.provoking_vertex == GL_FIRST_VERTEX_CONVENTION && state.lighting.shade_model == GL_FLAT);
    constexpr std::uint32_t POINTS = 1u << GL_POINTS,
                            LINES = 1u << GL_LINES | 1u << GL_LINE_STRIP | 1u << GL_LINE_LOOP;
    std::uint32_t needed = all ? ~0u : 0;
    if (work.smooth_points || raster.point_parameters.attenuates() || beyond_viewport) {
        needed |= POINTS;
    }
    if (work.smooth_lines || work.line_quads || raster.line_stipple.stipples() ||
        (beyond_viewport && line_width > 1)) {
        needed |= LINES;
    }
    if (work.unfilled) {
        needed |= ~(POINTS | LINES);
    }
    const bool does = (traits.modes & needed) ||
                      ((traits.modes & LINES) && loses_lines(state, backend, batch, beyond_viewport));
    return does ? std::optional(work) : std::nullopt;
}

} // namespace legacygl
