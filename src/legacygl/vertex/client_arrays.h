#pragma once

#include "legacygl/vertex/format.h"

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace legacygl {

/// The contents of a buffer object (OpenGL 1.5, 2.9).
struct BufferObject
{
    std::vector<std::uint8_t> bytes;
    GLenum usage = GL_STATIC_DRAW;
    GLenum access = GL_READ_WRITE;
    bool mapped = false;
};

/// One vertex array (OpenGL 1.5, table 6.6).
struct ClientArray
{
    bool enabled = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0;
    const void* pointer = nullptr; ///< An offset when there is a buffer.
    GLuint buffer_name = 0;
    std::shared_ptr<BufferObject> buffer;
};

/// Colour indices have no place in a vertex; their array comes after those of Attribute.
enum class OtherArray : std::uint8_t
{
    index,
    count
};
constexpr int CLIENT_ARRAY_COUNT = ATTRIBUTE_COUNT + static_cast<int>(OtherArray::count);

/// OpenGL 1.5, tables 6.6 to 6.8.
struct ClientArrays
{
    ClientArrays();
    std::array<ClientArray, CLIENT_ARRAY_COUNT> arrays;
    GLuint bound_array_buffer = 0;
    GLuint bound_element_buffer = 0;

    ClientArray& of(Attribute attribute) { return arrays[index_of(attribute)]; }
    const ClientArray& of(Attribute attribute) const { return arrays[index_of(attribute)]; }
    ClientArray& of(OtherArray array) { return arrays[ATTRIBUTE_COUNT + static_cast<int>(array)]; }
    const ClientArray& of(OtherArray array) const
    {
        return arrays[ATTRIBUTE_COUNT + static_cast<int>(array)];
    }
    /// Returns the array that glEnableClientState calls by that name, or null. client_unit: the unit whose
    /// texture coordinates are meant.
    const ClientArray* find(GLenum name, int client_unit) const;
    ClientArray* find(GLenum name, int client_unit)
    {
        return const_cast<ClientArray*>(std::as_const(*this).find(name, client_unit));
    }
};

inline ClientArrays::ClientArrays()
{
    of(Attribute::normal).size = 3;
    of(Attribute::secondary_color).size = 3;
    of(Attribute::fog_coordinate).size = 1;
    of(Attribute::edge_flag) = {false, 1, GL_UNSIGNED_BYTE, 0, nullptr, 0, nullptr};
    of(OtherArray::index).size = 1;
}

inline const ClientArray* ClientArrays::find(GLenum name, int client_unit) const
{
    switch (name) {
    case GL_VERTEX_ARRAY:
        return &of(Attribute::position);
    case GL_NORMAL_ARRAY:
        return &of(Attribute::normal);
    case GL_COLOR_ARRAY:
        return &of(Attribute::color);
    case GL_SECONDARY_COLOR_ARRAY:
        return &of(Attribute::secondary_color);
    case GL_FOG_COORDINATE_ARRAY:
        return &of(Attribute::fog_coordinate);
    case GL_TEXTURE_COORD_ARRAY:
        return &of(texture_coordinate(client_unit));
    case GL_EDGE_FLAG_ARRAY:
        return &of(Attribute::edge_flag);
    case GL_INDEX_ARRAY:
        return &of(OtherArray::index);
    default:
        return nullptr;
    }
}

} // namespace legacygl
