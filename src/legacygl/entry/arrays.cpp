// Vertex arrays (OpenGL 1.5, 2.8).

#define GL_GLEXT_PROTOTYPES
#include "legacygl/context/client_array_names.h"
#include "legacygl/context/dispatch.h"
#include "legacygl/vertex/array_reader.h"

#include <cstring>

using namespace legacygl;

namespace {

/// Returns the array that a client capability names, or null.
ClientArray* find_array(Context& gl, GLenum name)
{
    return gl.client_arrays.find(name, gl.state.texturing.client_active);
}

void enable_array(const char* entry, GLenum name, bool enabled)
{
    dispatch_now<Where::anywhere>(
        entry,
        [enabled](Context& gl, GLenum n) {
            ClientArray* array = find_array(gl, n);
            if (!array) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            array->enabled = enabled;
        },
        name);
}

bool is_one_of(GLenum value, std::initializer_list<GLenum> values)
{
    for (GLenum v : values) {
        if (v == value) {
            return true;
        }
    }
    return false;
}

void set_pointer(const char* entry, GLenum name, GLint size, GLenum type, GLsizei stride, const void* pointer,
                 GLint least, GLint greatest, std::initializer_list<GLenum> types)
{
    const bool type_is_good = is_one_of(type, types);
    dispatch_now<Where::anywhere>(
        entry,
        [=](Context& gl, GLint s, GLenum t, GLsizei st) {
            if (s < least || s > greatest || st < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            if (!type_is_good) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            ClientArray& array = *find_array(gl, name);
            array.size = s;
            array.type = t;
            array.stride = st;
            array.pointer = pointer;
            array.buffer_name = gl.client_arrays.bound_array_buffer;
            array.buffer = gl.find_buffer(array.buffer_name);
        },
        size, type, stride);
}

/// Draws elements as a glBegin, glArrayElement … glEnd does; what is current stays.
template <class Index>
void draw(Context& gl, VertexAssembler& to, GLenum mode, GLsizei count, bool indexed, Index index)
{
    const CurrentAttributes before = to.current();
    &to == &gl.immediate ? gl.begin(mode) : to.begin(mode);
    if (indexed) {
        to.set_indexed();
    }
    for (GLsizei i = 0; i < count; ++i) {
        give_element(gl.client_arrays, index(i), to);
    }
    &to == &gl.immediate ? gl.end() : to.end();
    if (&to == &gl.immediate) {
        for (int a = 1; a < ATTRIBUTE_COUNT; ++a) {
            if (gl.client_arrays.arrays[a].enabled) {
                to.attribute(static_cast<Attribute>(a), 4, before[a]);
            }
        }
    }
}

/// Sends a draw of arrays to where vertices go; the arrays are read now, also for a list.
template <class Index>
void draw_everywhere(const char* entry, GLenum mode, GLsizei count, bool indexed, Index index)
{
    Context* gl = current_context;
    if (!gl) {
        return;
    }
    if (gl->capture.active()) {
        gl->note(entry, mode, count);
    }
    if (mode > GL_POLYGON) {
        return gl->set_error(GL_INVALID_ENUM);
    }
    if (count < 0) {
        return gl->set_error(GL_INVALID_VALUE);
    }
    if (gl->immediate.inside() && !gl->compiler) {
        return gl->set_error(GL_INVALID_OPERATION);
    }
    if (!gl->client_arrays.of(Attribute::position).enabled || count == 0) {
        return;
    }
    if (gl->compiler) {
        draw(*gl, gl->compiler->vertices(), mode, count, indexed, index);
        if (!gl->compiler->executes()) {
            return;
        }
    }
    draw(*gl, gl->immediate, mode, count, indexed, index);
}

/// Returns the indices' bytes: the client's, or those of the bound element buffer, of at least size bytes.
const std::uint8_t* index_bytes(const GLvoid* indices, std::size_t size)
{
    const Context& gl = *current_context;
    const std::shared_ptr<BufferObject> buffer = gl.find_buffer(gl.client_arrays.bound_element_buffer);
    if (!buffer) {
        return static_cast<const std::uint8_t*>(indices);
    }
    const auto offset = reinterpret_cast<std::uintptr_t>(indices);
    return offset + size <= buffer->bytes.size() ? buffer->bytes.data() + offset : nullptr;
}

template <class T> void draw_indices(const char* entry, GLenum mode, GLsizei count, const GLvoid* indices)
{
    const std::uint8_t* bytes = current_context && count > 0
                                    ? index_bytes(indices, static_cast<std::size_t>(count) * sizeof(T))
                                    : nullptr;
    draw_everywhere(entry, mode, bytes || count < 0 ? count : 0, true, [bytes](GLsizei i) {
        T index;
        std::memcpy(&index, bytes + static_cast<std::size_t>(i) * sizeof(T), sizeof(T));
        return static_cast<GLint>(index);
    });
}

void draw_elements(const char* entry, GLenum mode, GLsizei count, GLenum type, const GLvoid* indices)
{
    switch (type) {
    case GL_UNSIGNED_BYTE:
        return draw_indices<GLubyte>(entry, mode, count, indices);
    case GL_UNSIGNED_SHORT:
        return draw_indices<GLushort>(entry, mode, count, indices);
    case GL_UNSIGNED_INT:
        return draw_indices<GLuint>(entry, mode, count, indices);
    default:
        if (current_context) {
            current_context->set_error(GL_INVALID_ENUM);
        }
    }
}

/// What glInterleavedArrays sets (OpenGL 1.5, table 2.5). Offsets and strides in bytes.
struct Interleaved
{
    GLenum format;
    GLint texture_size, color_size;
    GLenum color_type;
    bool normal;
    GLint vertex_size;
    int color_offset, normal_offset, vertex_offset, stride;
};

constexpr Interleaved INTERLEAVED[] = {
    {GL_V2F, 0, 0, 0, false, 2, 0, 0, 0, 8},
    {GL_V3F, 0, 0, 0, false, 3, 0, 0, 0, 12},
    {GL_C4UB_V2F, 0, 4, GL_UNSIGNED_BYTE, false, 2, 0, 0, 4, 12},
    {GL_C4UB_V3F, 0, 4, GL_UNSIGNED_BYTE, false, 3, 0, 0, 4, 16},
    {GL_C3F_V3F, 0, 3, GL_FLOAT, false, 3, 0, 0, 12, 24},
    {GL_N3F_V3F, 0, 0, 0, true, 3, 0, 0, 12, 24},
    {GL_C4F_N3F_V3F, 0, 4, GL_FLOAT, true, 3, 0, 16, 28, 40},
    {GL_T2F_V3F, 2, 0, 0, false, 3, 0, 0, 8, 20},
    {GL_T4F_V4F, 4, 0, 0, false, 4, 0, 0, 16, 32},
    {GL_T2F_C4UB_V3F, 2, 4, GL_UNSIGNED_BYTE, false, 3, 8, 0, 12, 24},
    {GL_T2F_C3F_V3F, 2, 3, GL_FLOAT, false, 3, 8, 0, 20, 32},
    {GL_T2F_N3F_V3F, 2, 0, 0, true, 3, 0, 8, 20, 32},
    {GL_T2F_C4F_N3F_V3F, 2, 4, GL_FLOAT, true, 3, 8, 24, 36, 48},
    {GL_T4F_C4F_N3F_V4F, 4, 4, GL_FLOAT, true, 4, 16, 32, 44, 60},
};

void set_interleaved(const Interleaved& f, GLsizei stride, const void* pointer)
{
    const auto* bytes = static_cast<const std::uint8_t*>(pointer);
    const GLsizei step = stride != 0 ? stride : f.stride;
    const auto enable = [](GLenum array, bool on) {
        on ? glEnableClientState(array) : glDisableClientState(array);
    };
    enable(GL_EDGE_FLAG_ARRAY, false);
    enable(GL_INDEX_ARRAY, false);
    enable(GL_TEXTURE_COORD_ARRAY, f.texture_size != 0);
    if (f.texture_size != 0) {
        glTexCoordPointer(f.texture_size, GL_FLOAT, step, bytes);
    }
    enable(GL_COLOR_ARRAY, f.color_size != 0);
    if (f.color_size != 0) {
        glColorPointer(f.color_size, f.color_type, step, bytes + f.color_offset);
    }
    enable(GL_NORMAL_ARRAY, f.normal);
    if (f.normal) {
        glNormalPointer(GL_FLOAT, step, bytes + f.normal_offset);
    }
    enable(GL_VERTEX_ARRAY, true);
    glVertexPointer(f.vertex_size, GL_FLOAT, step, bytes + f.vertex_offset);
}

} // namespace

extern "C" {

void glEnableClientState(GLenum cap)
{
    enable_array(__func__, cap, true);
}

void glDisableClientState(GLenum cap)
{
    enable_array(__func__, cap, false);
}

void glClientActiveTexture(GLenum texture)
{
    dispatch_now<Where::anywhere>(
        __func__,
        [](Context& gl, GLenum t) {
            if (t < GL_TEXTURE0 || t >= GL_TEXTURE0 + TEXTURE_UNIT_COUNT) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.texturing.client_active = static_cast<int>(t - GL_TEXTURE0);
        },
        texture);
}

void glVertexPointer(GLint size, GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_VERTEX_ARRAY, size, type, stride, ptr, 2, 4,
                {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
}

void glNormalPointer(GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_NORMAL_ARRAY, 3, type, stride, ptr, 3, 3,
                {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
}

void glColorPointer(GLint size, GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_COLOR_ARRAY, size, type, stride, ptr, 3, 4,
                {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT,
                 GL_DOUBLE});
}

void glSecondaryColorPointer(GLint size, GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_SECONDARY_COLOR_ARRAY, size, type, stride, ptr, 3, 3,
                {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT,
                 GL_DOUBLE});
}

void glFogCoordPointer(GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_FOG_COORDINATE_ARRAY, 1, type, stride, ptr, 1, 1, {GL_FLOAT, GL_DOUBLE});
}

void glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_TEXTURE_COORD_ARRAY, size, type, stride, ptr, 1, 4,
                {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
}

void glEdgeFlagPointer(GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_EDGE_FLAG_ARRAY, 1, GL_UNSIGNED_BYTE, stride, ptr, 1, 1, {GL_UNSIGNED_BYTE});
}

void glIndexPointer(GLenum type, GLsizei stride, const GLvoid* ptr)
{
    set_pointer(__func__, GL_INDEX_ARRAY, 1, type, stride, ptr, 1, 1,
                {GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
}

void glInterleavedArrays(GLenum format, GLsizei stride, const GLvoid* pointer)
{
    for (const Interleaved& f : INTERLEAVED) {
        if (f.format == format && stride >= 0) {
            return set_interleaved(f, stride, pointer);
        }
    }
    if (current_context) {
        current_context->set_error(stride < 0 ? GL_INVALID_VALUE : GL_INVALID_ENUM);
    }
}

void glArrayElement(GLint i)
{
    Context* gl = current_context;
    if (!gl) {
        return;
    }
    if (gl->capture.active()) {
        gl->note(__func__, i);
    }
    if (gl->compiler) {
        give_element(gl->client_arrays, i, gl->compiler->vertices());
        if (!gl->compiler->executes()) {
            return;
        }
    }
    give_element(gl->client_arrays, i, gl->immediate);
}

void glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    draw_everywhere(__func__, mode, count, false, [first](GLsizei i) { return first + i; });
}

void glDrawElements(GLenum mode, GLsizei count, GLenum type, const GLvoid* indices)
{
    draw_elements(__func__, mode, count, type, indices);
}

void glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                         const GLvoid* indices)
{
    if (end < start) {
        if (current_context) {
            current_context->set_error(GL_INVALID_VALUE);
        }
        return;
    }
    draw_elements(__func__, mode, count, type, indices);
}

void glMultiDrawArrays(GLenum mode, const GLint* first, const GLsizei* count, GLsizei drawcount)
{
    for (GLsizei i = 0; i < drawcount; ++i) {
        glDrawArrays(mode, first[i], count[i]);
    }
}

void glMultiDrawElements(GLenum mode, const GLsizei* count, GLenum type, const GLvoid* const* indices,
                         GLsizei drawcount)
{
    for (GLsizei i = 0; i < drawcount; ++i) {
        glDrawElements(mode, count[i], type, indices[i]);
    }
}

void glGetPointerv(GLenum pname, GLvoid** params)
{
    dispatch_now(
        __func__,
        [params](Context& gl, GLenum name) {
            for (const ClientArrayNames& names : CLIENT_ARRAY_NAMES) {
                if (names.pointer == name) {
                    *params = const_cast<void*>(find_array(gl, names.array)->pointer);
                    return;
                }
            }
            gl.set_error(GL_INVALID_ENUM);
        },
        pname);
}

} // extern "C"
