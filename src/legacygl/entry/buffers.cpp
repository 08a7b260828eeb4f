// Buffer objects for the vertex arrays (OpenGL 1.5, 2.9). They live in memory: arrays are read when drawn.

#define GL_GLEXT_PROTOTYPES
#include "legacygl/context/dispatch.h"

#include <cstring>

using namespace legacygl;

namespace {

/// Returns the binding of a target, or null when it is not one.
GLuint* binding(Context& gl, GLenum target)
{
    if (target == GL_ARRAY_BUFFER) {
        return &gl.client_arrays.bound_array_buffer;
    }
    return target == GL_ELEMENT_ARRAY_BUFFER ? &gl.client_arrays.bound_element_buffer : nullptr;
}

/// Returns the buffer bound to the target; null, with the error set, when there is none.
BufferObject* bound_buffer(Context& gl, GLenum target)
{
    const GLuint* name = binding(gl, target);
    if (!name) {
        gl.set_error(GL_INVALID_ENUM);
        return nullptr;
    }
    BufferObject* buffer = gl.find_buffer(*name).get();
    if (!buffer) {
        gl.set_error(GL_INVALID_OPERATION);
    }
    return buffer;
}

} // namespace

extern "C" {

void glGenBuffers(GLsizei n, GLuint* buffers)
{
    dispatch_now(
        __func__,
        [buffers](Context& gl, GLsizei count) {
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            GLuint name = 1;
            for (GLsizei i = 0; i < count; ++i, ++name) {
                while (gl.buffers.contains(name)) {
                    ++name;
                }
                gl.buffers[name] = nullptr; // Reserved; a buffer from its first binding on.
                buffers[i] = name;
            }
        },
        n);
}

void glDeleteBuffers(GLsizei n, const GLuint* buffers)
{
    dispatch_now(
        __func__,
        [buffers](Context& gl, GLsizei count) {
            if (count < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            for (GLsizei i = 0; i < count; ++i) {
                if (buffers[i] == 0) {
                    continue;
                }
                for (GLuint* name :
                     {&gl.client_arrays.bound_array_buffer, &gl.client_arrays.bound_element_buffer}) {
                    if (*name == buffers[i]) {
                        *name = 0;
                    }
                }
                gl.buffers.erase(buffers[i]);
            }
        },
        n);
}

GLboolean glIsBuffer(GLuint buffer)
{
    bool is_buffer = false;
    dispatch_now(
        __func__, [&is_buffer](Context& gl, GLuint name) { is_buffer = gl.find_buffer(name) != nullptr; },
        buffer);
    return is_buffer;
}

void glBindBuffer(GLenum target, GLuint buffer)
{
    dispatch_now(
        __func__,
        [](Context& gl, GLenum t, GLuint name) {
            GLuint* bound = binding(gl, t);
            if (!bound) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            if (name != 0 && !gl.buffers[name]) {
                gl.buffers[name] = std::make_shared<BufferObject>();
            }
            *bound = name;
        },
        target, buffer);
}

void glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
    dispatch_now(
        __func__,
        [data](Context& gl, GLenum t, GLsizeiptr s, GLenum u) {
            BufferObject* buffer = bound_buffer(gl, t);
            if (!buffer) {
                return;
            }
            if (s < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            buffer->bytes.assign(static_cast<std::size_t>(s), 0);
            if (data && s > 0) {
                std::memcpy(buffer->bytes.data(), data, static_cast<std::size_t>(s));
            }
            buffer->usage = u;
            buffer->mapped = false;
        },
        target, size, usage);
}

void glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data)
{
    dispatch_now(
        __func__,
        [data](Context& gl, GLenum t, GLintptr o, GLsizeiptr s) {
            BufferObject* buffer = bound_buffer(gl, t);
            if (!buffer) {
                return;
            }
            if (o < 0 || s < 0 || o + s > static_cast<GLsizeiptr>(buffer->bytes.size())) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            if (buffer->mapped) {
                return gl.set_error(GL_INVALID_OPERATION);
            }
            if (s > 0) {
                std::memcpy(buffer->bytes.data() + o, data, static_cast<std::size_t>(s));
            }
        },
        target, offset, size);
}

void glGetBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void* data)
{
    dispatch_now(
        __func__,
        [data](Context& gl, GLenum t, GLintptr o, GLsizeiptr s) {
            const BufferObject* buffer = bound_buffer(gl, t);
            if (!buffer) {
                return;
            }
            if (o < 0 || s < 0 || o + s > static_cast<GLsizeiptr>(buffer->bytes.size())) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            if (s > 0) {
                std::memcpy(data, buffer->bytes.data() + o, static_cast<std::size_t>(s));
            }
        },
        target, offset, size);
}

void* glMapBuffer(GLenum target, GLenum access)
{
    void* mapped = nullptr;
    dispatch_now(
        __func__,
        [&mapped](Context& gl, GLenum t, GLenum a) {
            BufferObject* buffer = bound_buffer(gl, t);
            if (!buffer) {
                return;
            }
            if (buffer->mapped) {
                return gl.set_error(GL_INVALID_OPERATION);
            }
            buffer->mapped = true;
            buffer->access = a;
            mapped = buffer->bytes.data();
        },
        target, access);
    return mapped;
}

GLboolean glUnmapBuffer(GLenum target)
{
    bool unmapped = false;
    dispatch_now(
        __func__,
        [&unmapped](Context& gl, GLenum t) {
            BufferObject* buffer = bound_buffer(gl, t);
            if (!buffer) {
                return;
            }
            if (!buffer->mapped) {
                return gl.set_error(GL_INVALID_OPERATION);
            }
            buffer->mapped = false;
            unmapped = true;
        },
        target);
    return unmapped;
}

void glGetBufferParameteriv(GLenum target, GLenum pname, GLint* params)
{
    dispatch_now(
        __func__,
        [params](Context& gl, GLenum t, GLenum name) {
            const BufferObject* buffer = bound_buffer(gl, t);
            if (!buffer) {
                return;
            }
            switch (name) {
            case GL_BUFFER_SIZE:
                *params = static_cast<GLint>(buffer->bytes.size());
                break;
            case GL_BUFFER_USAGE:
                *params = static_cast<GLint>(buffer->usage);
                break;
            case GL_BUFFER_ACCESS:
                *params = static_cast<GLint>(buffer->access);
                break;
            case GL_BUFFER_MAPPED:
                *params = buffer->mapped;
                break;
            default:
                gl.set_error(GL_INVALID_ENUM);
            }
        },
        target, pname);
}

} // extern "C"
