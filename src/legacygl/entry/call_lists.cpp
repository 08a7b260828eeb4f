// glCallLists and glListBase (OpenGL 1.5, 5.4).

#include "legacygl/context/dispatch.h"

#include <cstdint>
#include <cstring>

using namespace legacygl;

namespace {

/// Returns the bytes of one name of the type; 0: not a type of names.
int bytes_per_name(GLenum type)
{
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_2_BYTES:
        return 2;
    case GL_3_BYTES:
        return 3;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_4_BYTES:
        return 4;
    default:
        return 0;
    }
}

template <class T> GLuint read_as(const std::uint8_t* p)
{
    T value;
    std::memcpy(&value, p, sizeof value);
    return static_cast<GLuint>(static_cast<std::int64_t>(value));
}

/// Returns the offset from the list base that a name gives; negative ones wrap round, as the sum does.
GLuint read_name(GLenum type, const std::uint8_t* p)
{
    switch (type) {
    case GL_BYTE:
        return read_as<GLbyte>(p);
    case GL_UNSIGNED_BYTE:
        return *p;
    case GL_SHORT:
        return read_as<GLshort>(p);
    case GL_UNSIGNED_SHORT:
        return read_as<GLushort>(p);
    case GL_INT:
        return read_as<GLint>(p);
    case GL_UNSIGNED_INT:
        return read_as<GLuint>(p);
    case GL_FLOAT:
        return read_as<GLfloat>(p);
    default: { // GL_2_BYTES … GL_4_BYTES: the most significant byte first.
        GLuint name = 0;
        for (int i = 0; i < bytes_per_name(type); ++i) {
            name = name * 256 + p[i];
        }
        return name;
    }
    }
}

void call_lists(Context& gl, GLsizei count, GLenum type, const Blob& names)
{
    if (count < 0) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    const int size = bytes_per_name(type);
    if (size == 0) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    const auto* bytes = static_cast<const std::uint8_t*>(names.data);
    for (GLsizei i = 0; i < count; ++i) {
        gl.call_list(gl.state.list_base + read_name(type, bytes + static_cast<std::size_t>(i) * size));
    }
}

} // namespace

extern "C" {

void glCallLists(GLsizei n, GLenum type, const GLvoid* lists)
{
    const std::size_t size = n > 0 ? static_cast<std::size_t>(n) * bytes_per_name(type) : 0;
    dispatch<Where::anywhere>(__func__, call_lists, n, type, Blob{lists, size});
}

void glListBase(GLuint base)
{
    dispatch(__func__, [](Context& gl, GLuint b) { gl.state.list_base = b; }, base);
}

} // extern "C"
