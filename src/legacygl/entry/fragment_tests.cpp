// The tests of a fragment and blending (OpenGL 1.5, 4.1).

#define GL_GLEXT_PROTOTYPES
#include "legacygl/context/dispatch.h"

#include <algorithm>

using namespace legacygl;

namespace {

bool is_blend_factor(GLenum factor, bool source)
{
    switch (factor) {
    case GL_ZERO:
    case GL_ONE:
    case GL_SRC_COLOR:
    case GL_ONE_MINUS_SRC_COLOR:
    case GL_DST_COLOR:
    case GL_ONE_MINUS_DST_COLOR:
    case GL_SRC_ALPHA:
    case GL_ONE_MINUS_SRC_ALPHA:
    case GL_DST_ALPHA:
    case GL_ONE_MINUS_DST_ALPHA:
    case GL_CONSTANT_COLOR:
    case GL_ONE_MINUS_CONSTANT_COLOR:
    case GL_CONSTANT_ALPHA:
    case GL_ONE_MINUS_CONSTANT_ALPHA:
        return true;
    case GL_SRC_ALPHA_SATURATE:
        return source;
    default:
        return false;
    }
}

bool is_comparison(GLenum func)
{
    return func >= GL_NEVER && func <= GL_ALWAYS;
}

bool is_stencil_operation(GLenum operation)
{
    switch (operation) {
    case GL_KEEP:
    case GL_ZERO:
    case GL_REPLACE:
    case GL_INCR:
    case GL_DECR:
    case GL_INVERT:
    case GL_INCR_WRAP:
    case GL_DECR_WRAP:
        return true;
    default:
        return false;
    }
}

void set_blend_factors(Context& gl, GLenum source_rgb, GLenum destination_rgb, GLenum source_alpha,
                       GLenum destination_alpha)
{
    if (!is_blend_factor(source_rgb, true) || !is_blend_factor(destination_rgb, false) ||
        !is_blend_factor(source_alpha, true) || !is_blend_factor(destination_alpha, false)) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    BlendState& blend = gl.state.fragment.blend;
    blend.source_rgb = source_rgb;
    blend.destination_rgb = destination_rgb;
    blend.source_alpha = source_alpha;
    blend.destination_alpha = destination_alpha;
    gl.renderer.changed(change::pipeline | change::fragments);
}

bool is_blend_equation(GLenum mode)
{
    return mode == GL_FUNC_ADD || mode == GL_FUNC_SUBTRACT || mode == GL_FUNC_REVERSE_SUBTRACT ||
           mode == GL_MIN || mode == GL_MAX;
}

void set_blend_equations(Context& gl, GLenum rgb, GLenum alpha)
{
    if (!is_blend_equation(rgb) || !is_blend_equation(alpha)) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    gl.state.fragment.blend.equation = rgb;
    gl.state.fragment.blend.equation_alpha = alpha;
    gl.renderer.changed(change::pipeline | change::fragments);
}

} // namespace

extern "C" {

void glBlendFunc(GLenum sfactor, GLenum dfactor)
{
    dispatch(
        __func__, [](Context& gl, GLenum s, GLenum d) { set_blend_factors(gl, s, d, s, d); }, sfactor,
        dfactor);
}

void glBlendFuncSeparate(GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha, GLenum dfactorAlpha)
{
    dispatch(__func__, set_blend_factors, sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha);
}

void glBlendEquation(GLenum mode)
{
    dispatch(__func__, [](Context& gl, GLenum m) { set_blend_equations(gl, m, m); }, mode);
}

void glBlendEquationSeparate(GLenum modeRGB, GLenum modeAlpha)
{
    dispatch(__func__, set_blend_equations, modeRGB, modeAlpha);
}

void glBlendColor(GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha)
{
    dispatch(
        __func__,
        [](Context& gl, float r, float g, float b, float a) {
            const auto clamp = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
            gl.state.fragment.blend.color = {clamp(r), clamp(g), clamp(b), clamp(a)};
            gl.renderer.changed(change::pipeline | change::fragments);
        },
        red, green, blue, alpha);
}

void glDepthFunc(GLenum func)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum f) {
            if (f < GL_NEVER || f > GL_ALWAYS) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.fragment.depth_func = f;
            gl.renderer.changed(change::pipeline);
        },
        func);
}

void glAlphaFunc(GLenum func, GLclampf ref)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum f, float r) {
            if (!is_comparison(f)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.fragment.alpha_func = f;
            gl.state.fragment.alpha_reference = std::clamp(r, 0.0f, 1.0f);
            gl.renderer.changed(change::fragments);
        },
        func, ref);
}

void glScissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
    dispatch(
        __func__,
        [](Context& gl, GLint left, GLint bottom, GLsizei w, GLsizei h) {
            if (w < 0 || h < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.state.fragment.scissor_box = {left, bottom, w, h};
            gl.renderer.changed(change::pipeline);
        },
        x, y, width, height);
}

void glStencilFunc(GLenum func, GLint ref, GLuint mask)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum f, GLint r, GLuint m) {
            if (!is_comparison(f)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            StencilState& stencil = gl.state.fragment.stencil;
            stencil.func = f;
            stencil.reference = std::clamp(r, 0, 255); // Of eight bits.
            stencil.value_mask = m;
            gl.renderer.changed(change::pipeline);
        },
        func, ref, mask);
}

void glStencilOp(GLenum fail, GLenum zfail, GLenum zpass)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum f, GLenum zf, GLenum zp) {
            if (!is_stencil_operation(f) || !is_stencil_operation(zf) || !is_stencil_operation(zp)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            StencilState& stencil = gl.state.fragment.stencil;
            stencil.fail = f;
            stencil.depth_fail = zf;
            stencil.depth_pass = zp;
            gl.renderer.changed(change::pipeline);
        },
        fail, zfail, zpass);
}

void glSampleCoverage(GLclampf value, GLboolean invert)
{
    dispatch(
        __func__,
        [](Context& gl, float v, GLboolean i) {
            gl.state.multisample.coverage_value = std::clamp(v, 0.0f, 1.0f);
            gl.state.multisample.coverage_invert = i != GL_FALSE;
        },
        value, invert);
}

} // extern "C"
