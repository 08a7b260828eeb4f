#pragma once

#include "legacygl/state/change.h"
#include "legacygl/state/state.h"

namespace legacygl {

/// Gives every capability of a texture unit to visit(name, group, change, flag), as visit_capabilities does.
template <class Visit> void visit_unit_capabilities(TextureUnit& unit, Visit&& visit)
{
    for (int i = 0; i < TEXTURE_TARGET_COUNT; ++i) {
        visit(GL_TEXTURE_1D + i, GL_TEXTURE_BIT, change::texturing, unit.enabled[i]);
    }
    for (int i = 0; i < 4; ++i) {
        visit(GL_TEXTURE_GEN_S + i, GL_TEXTURE_BIT, change::texturing, unit.generation[i].enabled);
    }
}

/// Gives every other capability to visit(name, group, change, flag): what glEnable calls it, the group of
/// glPushAttrib that it belongs to besides GL_ENABLE_BIT (OpenGL 1.5, tables 6.9 to 6.21), what a draw must
/// look at again when it changes, and where it is. The one table that glEnable, glIsEnabled, glGet and
/// glPushAttrib read.
template <class Visit> void visit_capabilities(State& s, Visit&& visit)
{
    visit(GL_LIGHTING, GL_LIGHTING_BIT, change::lighting, s.lighting.enabled);
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        visit(GL_LIGHT0 + i, GL_LIGHTING_BIT, change::lighting, s.lighting.lights[i].enabled);
    }
    visit(GL_COLOR_MATERIAL, GL_LIGHTING_BIT, change::lighting, s.lighting.color_material);
    visit(GL_NORMALIZE, GL_TRANSFORM_BIT, change::lighting, s.transform.normalize);
    visit(GL_RESCALE_NORMAL, GL_TRANSFORM_BIT, change::lighting, s.transform.rescale_normal);
    for (int i = 0; i < CLIP_PLANE_COUNT; ++i) {
        visit(GL_CLIP_PLANE0 + i, GL_TRANSFORM_BIT, change::pipeline, s.transform.clip_planes[i].enabled);
    }
    visit(GL_FOG, GL_FOG_BIT, change::fragments, s.fog.enabled);
    visit(GL_COLOR_SUM, GL_FOG_BIT, change::lighting, s.lighting.color_sum);
    visit(GL_CULL_FACE, GL_POLYGON_BIT, change::pipeline, s.raster.cull_face);
    visit(GL_POLYGON_SMOOTH, GL_POLYGON_BIT, change::pipeline, s.raster.polygon_smooth);
    visit(GL_POLYGON_STIPPLE, GL_POLYGON_BIT, change::fragments, s.raster.polygon_stipple.enabled);
    visit(GL_LINE_SMOOTH, GL_LINE_BIT, change::pipeline, s.raster.line_smooth);
    visit(GL_LINE_STIPPLE, GL_LINE_BIT, change::pipeline, s.raster.line_stipple.enabled);
    visit(GL_POINT_SMOOTH, GL_POINT_BIT, change::pipeline, s.raster.point_smooth);
    visit(GL_POLYGON_OFFSET_FILL, GL_POLYGON_BIT, change::pipeline, s.raster.polygon_offset_fill);
    visit(GL_POLYGON_OFFSET_LINE, GL_POLYGON_BIT, change::pipeline, s.raster.polygon_offset_line);
    visit(GL_POLYGON_OFFSET_POINT, GL_POLYGON_BIT, change::pipeline, s.raster.polygon_offset_point);
    visit(GL_DEPTH_TEST, GL_DEPTH_BUFFER_BIT, change::pipeline, s.fragment.depth_test);
    visit(GL_STENCIL_TEST, GL_STENCIL_BUFFER_BIT, change::pipeline, s.fragment.stencil.enabled);
    visit(GL_SCISSOR_TEST, GL_SCISSOR_BIT, change::pipeline, s.fragment.scissor_test);
    visit(GL_ALPHA_TEST, GL_COLOR_BUFFER_BIT, change::fragments, s.fragment.alpha_test);
    visit(GL_BLEND, GL_COLOR_BUFFER_BIT, change::pipeline, s.fragment.blend.enabled);
    visit(GL_COLOR_LOGIC_OP, GL_COLOR_BUFFER_BIT, change::pipeline, s.fragment.color_logic_op);
    visit(GL_INDEX_LOGIC_OP, GL_COLOR_BUFFER_BIT, change::pipeline, s.fragment.index_logic_op);
    visit(GL_DITHER, GL_COLOR_BUFFER_BIT, change::pipeline, s.fragment.dither);
    visit(GL_AUTO_NORMAL, GL_EVAL_BIT, 0u, s.auto_normal);
    // A target has one sample a pixel: these are kept and change nothing.
    visit(GL_MULTISAMPLE, GL_MULTISAMPLE_BIT, 0u, s.multisample.enabled);
    visit(GL_SAMPLE_ALPHA_TO_COVERAGE, GL_MULTISAMPLE_BIT, 0u, s.multisample.alpha_to_coverage);
    visit(GL_SAMPLE_ALPHA_TO_ONE, GL_MULTISAMPLE_BIT, 0u, s.multisample.alpha_to_one);
    visit(GL_SAMPLE_COVERAGE, GL_MULTISAMPLE_BIT, 0u, s.multisample.coverage);
}

/// Something that glEnable switches: where its flag is, and what a draw must look at again.
struct Capability
{
    bool* flag = nullptr; ///< Null: not a capability.
    std::uint32_t change = 0;
};

/// Finds a capability by its name; those of textures are the active unit's.
inline Capability find_capability(State& state, GLenum capability)
{
    Capability found;
    const auto look = [&](GLenum name, GLbitfield, std::uint32_t change, bool& flag) {
        if (name == capability) {
            found = {&flag, change};
        }
    };
    visit_capabilities(state, look);
    visit_unit_capabilities(state.texturing.unit(), look);
    return found;
}

} // namespace legacygl
