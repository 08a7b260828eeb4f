// Rasterising state, masks, clearing and finishing (OpenGL 1.5, 3.3 to 3.5 and 4.2).

#include "legacygl/context/dispatch.h"

#include <algorithm>

using namespace legacygl;

namespace {

bool is_face(GLenum face)
{
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

} // namespace

extern "C" {

void glCullFace(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (!is_face(m)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.raster.cull_face_mode = m;
            gl.renderer.changed(change::pipeline);
        },
        mode);
}

void glFrontFace(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (m != GL_CW && m != GL_CCW) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.raster.front_face = m;
            gl.renderer.changed(change::pipeline);
        },
        mode);
}

void glLineWidth(GLfloat width)
{
    dispatch(
        __func__,
        [](Context& gl, float w) {
            if (!(w > 0)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.state.raster.line_width = w;
            gl.renderer.changed(change::pipeline);
        },
        width);
}

void glPointSize(GLfloat size)
{
    dispatch(
        __func__,
        [](Context& gl, float s) {
            if (!(s > 0)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.state.raster.point_size = s;
            gl.renderer.changed(change::matrices); // It lies beside the matrices.
        },
        size);
}

void glPolygonOffset(GLfloat factor, GLfloat units)
{
    dispatch(
        __func__,
        [](Context& gl, float f, float u) {
            gl.state.raster.polygon_offset_factor = f;
            gl.state.raster.polygon_offset_units = u;
            gl.renderer.changed(change::pipeline);
        },
        factor, units);
}

void glDepthMask(GLboolean flag)
{
    dispatch(
        __func__,
        [](Context& gl, GLboolean f) {
            gl.state.fragment.depth_mask = f != GL_FALSE;
            gl.renderer.changed(change::pipeline);
        },
        flag);
}

void glColorMask(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha)
{
    dispatch(
        __func__,
        [](Context& gl, GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
            gl.state.fragment.color_mask = {r != GL_FALSE, g != GL_FALSE, b != GL_FALSE, a != GL_FALSE};
            gl.renderer.changed(change::pipeline);
        },
        red, green, blue, alpha);
}

void glStencilMask(GLuint mask)
{
    dispatch(
        __func__,
        [](Context& gl, GLuint m) {
            gl.state.fragment.stencil.write_mask = m;
            gl.renderer.changed(change::pipeline);
        },
        mask);
}

void glClearColor(GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha)
{
    dispatch(
        __func__,
        [](Context& gl, float r, float g, float b, float a) {
            const auto clamp = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
            gl.state.fragment.clear_color = {clamp(r), clamp(g), clamp(b), clamp(a)};
        },
        red, green, blue, alpha);
}

void glClearDepth(GLclampd depth)
{
    dispatch(
        __func__, [](Context& gl, double d) { gl.state.fragment.clear_depth = std::clamp(d, 0.0, 1.0); },
        depth);
}

void glClearStencil(GLint s)
{
    dispatch(__func__, [](Context& gl, GLint value) { gl.state.fragment.clear_stencil = value; }, s);
}

void glClear(GLbitfield mask)
{
    dispatch(
        __func__,
        [](Context& gl, GLbitfield buffers) {
            constexpr GLbitfield ours = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
            if (buffers & ~(ours | GL_ACCUM_BUFFER_BIT)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.renderer.clear(gl.state, buffers & ours);
        },
        mask);
}

void glFlush()
{
    dispatch_now(__func__, [](Context& gl) { gl.backend->flush(false); });
}

void glFinish()
{
    dispatch_now(__func__, [](Context& gl) { gl.backend->flush(true); });
}

} // extern "C"
