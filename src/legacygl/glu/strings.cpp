// What GLU says of itself and of errors (GLU 1.3, chapters 2 and 8).

#include <GL/gl.h>
#include <GL/glu.h>

#include <string_view>

namespace {

const char* error_text(GLenum error)
{
    switch (error) {
    case GL_NO_ERROR:
        return "no error";
    case GL_INVALID_ENUM:
    case GLU_INVALID_ENUM:
        return "invalid enumerant";
    case GL_INVALID_VALUE:
    case GLU_INVALID_VALUE:
        return "invalid value";
    case GL_INVALID_OPERATION:
    case GLU_INVALID_OPERATION:
        return "invalid operation";
    case GL_STACK_OVERFLOW:
        return "stack overflow";
    case GL_STACK_UNDERFLOW:
        return "stack underflow";
    case GL_OUT_OF_MEMORY:
    case GLU_OUT_OF_MEMORY:
        return "out of memory";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "invalid framebuffer operation";
    case GL_TABLE_TOO_LARGE:
        return "table too large";
    case GLU_INCOMPATIBLE_GL_VERSION:
        return "incompatible gl version";
    default:
        return nullptr; // The errors of tessellators and NURBS come from neither.
    }
}

const GLubyte* bytes(const char* text)
{
    return reinterpret_cast<const GLubyte*>(text);
}

} // namespace

const GLubyte* gluErrorString(GLenum error)
{
    return bytes(error_text(error));
}

const GLubyte* gluGetString(GLenum name)
{
    switch (name) {
    case GLU_VERSION:
        return bytes("1.3");
    case GLU_EXTENSIONS:
        return bytes("");
    default:
        return nullptr;
    }
}

GLboolean gluCheckExtension(const GLubyte* extName, const GLubyte* extString)
{
    if (!extName || !extString) {
        return GL_FALSE;
    }
    const std::string_view name = reinterpret_cast<const char*>(extName);
    std::string_view rest = reinterpret_cast<const char*>(extString);
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        if (!name.empty() && word == name) {
            return GL_TRUE;
        }
        rest.remove_prefix(word.size() < rest.size() ? word.size() + 1 : word.size());
    }
    return GL_FALSE;
}
