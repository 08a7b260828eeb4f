// Which colour buffer is drawn into and read (OpenGL 1.5, 4.2.1 and 4.3.2).

#include "legacygl/context/dispatch.h"

using namespace legacygl;

namespace {

/// Returns what is wrong with naming that colour buffer, or GL_NO_ERROR. There is no right one and no
/// auxiliary one, and without double buffering no back one.
GLenum buffer_error(const Context& gl, GLenum name)
{
    switch (name) {
    case GL_FRONT_LEFT:
    case GL_FRONT:
    case GL_LEFT:
        return GL_NO_ERROR;
    case GL_BACK_LEFT:
    case GL_BACK:
        return gl.double_buffered ? GL_NO_ERROR : GL_INVALID_OPERATION;
    case GL_FRONT_RIGHT:
    case GL_BACK_RIGHT:
    case GL_RIGHT:
    case GL_AUX0:
    case GL_AUX1:
    case GL_AUX2:
    case GL_AUX3:
        return GL_INVALID_OPERATION;
    default:
        return GL_INVALID_ENUM;
    }
}

} // namespace

extern "C" {

void glDrawBuffer(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            const bool several = m == GL_NONE || m == GL_FRONT_AND_BACK;
            if (const GLenum error = buffer_error(gl, m); !several && error != GL_NO_ERROR) {
                return gl.set_error(error);
            }
            gl.state.fragment.draw_buffer = m;
            gl.renderer.changed(change::everything);
        },
        mode);
}

void glReadBuffer(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (const GLenum error = buffer_error(gl, m); error != GL_NO_ERROR) {
                return gl.set_error(error);
            }
            gl.state.fragment.read_buffer = m;
        },
        mode);
}

} // extern "C"
