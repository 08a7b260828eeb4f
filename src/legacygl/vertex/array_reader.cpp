#include "legacygl/vertex/array_reader.h"

#include "legacygl/vertex/component.h"

#include <cstring>

namespace legacygl {
namespace {

int size_of(GLenum type)
{
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_DOUBLE:
        return 8;
    default:
        return 4;
    }
}

template <class T> float read_as(const std::uint8_t* p, bool fraction)
{
    T value;
    std::memcpy(&value, p, sizeof value);
    return fraction ? component(value) : static_cast<float>(value);
}

/// Unlike glColor3ub, Mesa reads an array's bytes by multiplying, which may round to another float.
float read_unsigned_byte(const std::uint8_t* p, bool fraction)
{
    return static_cast<float>(*p) * (fraction ? 1.0f / 255.0f : 1.0f);
}

float read_component(GLenum type, const std::uint8_t* p, bool fraction)
{
    switch (type) {
    case GL_BYTE:
        return read_as<GLbyte>(p, fraction);
    case GL_UNSIGNED_BYTE:
        return read_unsigned_byte(p, fraction);
    case GL_SHORT:
        return read_as<GLshort>(p, fraction);
    case GL_UNSIGNED_SHORT:
        return read_as<GLushort>(p, fraction);
    case GL_INT:
        return read_as<GLint>(p, fraction);
    case GL_UNSIGNED_INT:
        return read_as<GLuint>(p, fraction);
    case GL_DOUBLE:
        return read_as<GLdouble>(p, fraction);
    default:
        return read_as<GLfloat>(p, fraction);
    }
}

} // namespace

glm::vec4 read_element(const ClientArray& array, Attribute attribute, GLint i)
{
    const int component_size = size_of(array.type), size = array.size * component_size;
    const std::ptrdiff_t stride = array.stride != 0 ? array.stride : size;
    const std::ptrdiff_t offset = stride * i;
    glm::vec4 value = {0, 0, 0, 1};
    const std::uint8_t* p = nullptr;
    if (array.buffer) {
        const auto at = static_cast<std::ptrdiff_t>(reinterpret_cast<std::uintptr_t>(array.pointer)) + offset;
        if (at < 0 || at + size > static_cast<std::ptrdiff_t>(array.buffer->bytes.size())) {
            return value;
        }
        p = array.buffer->bytes.data() + at;
    } else {
        p = static_cast<const std::uint8_t*>(array.pointer);
        if (!p) {
            return value;
        }
        p += offset;
    }
    const bool fraction = attribute == Attribute::normal || attribute == Attribute::color ||
                          attribute == Attribute::secondary_color;
    for (int c = 0; c < array.size; ++c) {
        value[c] = read_component(array.type, p + c * component_size, fraction);
    }
    if (attribute == Attribute::edge_flag) {
        value.x = value.x != 0 ? 1.0f : 0.0f;
    }
    return value;
}

} // namespace legacygl
