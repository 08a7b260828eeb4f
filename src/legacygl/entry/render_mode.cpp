// The render mode, of which there is one so far, and names, which it ignores (OpenGL 1.5, 5.2 and 5.3).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/unimplemented.h"

using namespace legacygl;

namespace {

/// Outside selection a command on the stack of names does nothing.
template <class... Args> void ignore(const char* name, Args... args)
{
    dispatch(name, [](Context&, auto...) {}, args...);
}

} // namespace

extern "C" {

/// Returns 0: what GL_RENDER counts is nothing.
GLint glRenderMode(GLenum mode)
{
    dispatch_now(
        __func__,
        [](Context& gl, GLenum m) {
            if (m == GL_SELECT) {
                LEGACYGL_REFUSE("glRenderMode(GL_SELECT)");
            } else if (m == GL_FEEDBACK) {
                LEGACYGL_REFUSE("glRenderMode(GL_FEEDBACK)");
            } else if (m != GL_RENDER) {
                gl.set_error(GL_INVALID_ENUM);
            }
        },
        mode);
    return 0;
}

void glInitNames()
{
    ignore(__func__);
}

void glLoadName(GLuint name)
{
    ignore(__func__, name);
}

void glPushName(GLuint name)
{
    ignore(__func__, name);
}

void glPopName()
{
    ignore(__func__);
}

} // extern "C"
