// Queries (OpenGL 1.5, 6.1).

#include "legacygl/dispatch.h"
#include "legacygl/query_convert.h"

using namespace legacygl;

namespace {

template <class T> void get(const char* entry, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum n) {
            const QueryValue value = query(gl, n);
            if (value.count == 0)
                return gl.set_error(GL_INVALID_ENUM);
            write_values(value, params);
        },
        name);
}

} // namespace

extern "C" {

void glGetBooleanv(GLenum pname, GLboolean* params)
{
    get(__func__, pname, params);
}

void glGetIntegerv(GLenum pname, GLint* params)
{
    get(__func__, pname, params);
}

void glGetFloatv(GLenum pname, GLfloat* params)
{
    get(__func__, pname, params);
}

void glGetDoublev(GLenum pname, GLdouble* params)
{
    get(__func__, pname, params);
}

GLenum glGetError()
{
    GLenum code = GL_NO_ERROR;
    dispatch_now(__func__, [&code](Context& gl) { code = std::exchange(gl.error, GL_NO_ERROR); });
    return code;
}

const GLubyte* glGetString(GLenum name)
{
    const char* text = nullptr;
    dispatch_now(
        __func__,
        [&text](Context& gl, GLenum n) {
            switch (n) {
            case GL_VENDOR:
                text = "Tank Lab";
                break;
            case GL_RENDERER:
                text = "legacygl";
                break;
            case GL_VERSION:
                text = "1.0 legacygl (a part of OpenGL 1.1; see legacygl.h)";
                break;
            case GL_EXTENSIONS:
                text = "";
                break;
            default:
                gl.set_error(GL_INVALID_ENUM);
            }
        },
        name);
    return reinterpret_cast<const GLubyte*>(text);
}

} // extern "C"
