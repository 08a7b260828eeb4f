// Display lists (OpenGL 1.5, 5.4).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/list_replay.h"

using namespace legacygl;

extern "C" {

GLuint glGenLists(GLsizei range)
{
    GLuint first = 0;
    dispatch_now(
        __func__,
        [&first](Context& gl, GLsizei count) {
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            first = gl.lists.generate(count);
        },
        range);
    return first;
}

void glNewList(GLuint list, GLenum mode)
{
    dispatch_now(
        __func__,
        [](Context& gl, GLuint name, GLenum m) {
            if (name == 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            if (m != GL_COMPILE && m != GL_COMPILE_AND_EXECUTE) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            if (gl.compiler) {
                return gl.set_error(GL_INVALID_OPERATION);
            }
            gl.compiler.emplace(name, m == GL_COMPILE_AND_EXECUTE, replay);
        },
        list, mode);
}

void glEndList()
{
    dispatch_now(__func__, [](Context& gl) {
        if (!gl.compiler) {
            return gl.set_error(GL_INVALID_OPERATION);
        }
        const GLuint name = gl.compiler->name();
        gl.lists.put(name, gl.compiler->finish());
        gl.compiler.reset();
    });
}

void glCallList(GLuint list)
{
    dispatch<Where::anywhere>(__func__, [](Context& gl, GLuint name) { gl.call_list(name); }, list);
}

void glDeleteLists(GLuint list, GLsizei range)
{
    dispatch_now(
        __func__,
        [](Context& gl, GLuint first, GLsizei count) {
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.lists.erase(first, count);
        },
        list, range);
}

GLboolean glIsList(GLuint list)
{
    bool is_list = false;
    dispatch_now(__func__, [&is_list](Context& gl, GLuint name) { is_list = gl.lists.contains(name); }, list);
    return is_list;
}

} // extern "C"
