// The frame buffer as a whole: masks, clearing, finishing, and logic operations (OpenGL 1.5, 4.1.10 and 4.2).

#include "legacygl/context/dispatch.h"

#include <algorithm>

using namespace legacygl;

extern "C" {

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
            constexpr GLbitfield SUPPORTED =
                GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
            if (buffers & ~(SUPPORTED | GL_ACCUM_BUFFER_BIT)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.renderer.clear(gl.state, buffers & SUPPORTED);
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

void glLogicOp(GLenum opcode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum op) {
            if (op < GL_CLEAR || op > GL_SET) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.fragment.logic_op = op;
            gl.renderer.changed(change::pipeline);
        },
        opcode);
}

} // extern "C"
