#pragma once

#include "legacygl/renderer.h"
#include "legacygl/state/state.h"

namespace legacygl {

/// Something that glEnable switches: where its flag is, and what a draw must look at again.
struct Capability
{
    bool* flag; ///< Null: not a capability.
    std::uint32_t change;
};

/// Finds a capability; the one table that glEnable, glDisable and glIsEnabled read.
inline Capability find_capability(State& state, GLenum capability)
{
    LightingState& lighting = state.lighting;
    if (capability >= GL_LIGHT0 && capability < GL_LIGHT0 + LIGHT_COUNT)
        return {&lighting.lights[capability - GL_LIGHT0].enabled, Renderer::lighting};
    if (capability >= GL_CLIP_PLANE0 && capability < GL_CLIP_PLANE0 + CLIP_PLANE_COUNT)
        return {&state.transform.clip_planes[capability - GL_CLIP_PLANE0].enabled, Renderer::pipeline};
    switch (capability) {
    case GL_LIGHTING:
        return {&lighting.enabled, Renderer::lighting};
    case GL_COLOR_MATERIAL:
        return {&lighting.color_material, Renderer::lighting};
    case GL_NORMALIZE:
        return {&state.transform.normalize, Renderer::lighting};
    case GL_RESCALE_NORMAL:
        return {&state.transform.rescale_normal, Renderer::lighting};
    case GL_TEXTURE_1D:
    case GL_TEXTURE_2D:
        return {&state.texturing.unit().enabled[capability - GL_TEXTURE_1D], Renderer::texturing};
    case GL_TEXTURE_GEN_S:
    case GL_TEXTURE_GEN_T:
    case GL_TEXTURE_GEN_R:
    case GL_TEXTURE_GEN_Q:
        return {&state.texturing.unit().generation[capability - GL_TEXTURE_GEN_S].enabled,
                Renderer::texturing};
    case GL_FOG:
        return {&state.fog.enabled, Renderer::fragments};
    case GL_COLOR_SUM:
        return {&state.lighting.color_sum, Renderer::lighting};
    case GL_CULL_FACE:
        return {&state.raster.cull_face, Renderer::pipeline};
    case GL_DEPTH_TEST:
        return {&state.fragment.depth_test, Renderer::pipeline};
    case GL_BLEND:
        return {&state.fragment.blend.enabled, Renderer::pipeline};
    case GL_SCISSOR_TEST:
        return {&state.fragment.scissor_test, Renderer::pipeline};
    case GL_STENCIL_TEST:
        return {&state.fragment.stencil.enabled, Renderer::pipeline};
    case GL_ALPHA_TEST:
        return {&state.fragment.alpha_test, Renderer::fragments};
    case GL_POLYGON_OFFSET_FILL:
        return {&state.raster.polygon_offset_fill, Renderer::pipeline};
    case GL_POLYGON_OFFSET_LINE:
        return {&state.raster.polygon_offset_line, Renderer::pipeline};
    case GL_POLYGON_OFFSET_POINT:
        return {&state.raster.polygon_offset_point, Renderer::pipeline};
    case GL_POLYGON_SMOOTH:
        return {&state.raster.polygon_smooth, Renderer::pipeline};
    case GL_POLYGON_STIPPLE:
        return {&state.raster.polygon_stipple.enabled, Renderer::fragments};
    case GL_LINE_SMOOTH:
        return {&state.raster.line_smooth, Renderer::pipeline};
    case GL_LINE_STIPPLE:
        return {&state.raster.line_stipple.enabled, Renderer::pipeline};
    case GL_POINT_SMOOTH:
        return {&state.raster.point_smooth, Renderer::pipeline};
    case GL_COLOR_LOGIC_OP:
        return {&state.fragment.color_logic_op, Renderer::pipeline};
    case GL_INDEX_LOGIC_OP:
        return {&state.fragment.index_logic_op, Renderer::pipeline};
    case GL_DITHER:
        return {&state.fragment.dither, Renderer::pipeline};
    default:
        return {nullptr, 0};
    }
}

} // namespace legacygl
