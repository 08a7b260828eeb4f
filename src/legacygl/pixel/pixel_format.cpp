#include "legacygl/pixel/pixel_format.h"

namespace legacygl {
namespace {

constexpr PackedType PACKED_TYPES[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, {3, 3, 2, 0}, false},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, {3, 3, 2, 0}, true},
    {GL_UNSIGNED_SHORT_5_6_5, 2, {5, 6, 5, 0}, false},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, {5, 6, 5, 0}, true},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, {4, 4, 4, 4}, false},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, {4, 4, 4, 4}, true},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, {5, 5, 5, 1}, false},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, {5, 5, 5, 1}, true},
    {GL_UNSIGNED_INT_8_8_8_8, 4, {8, 8, 8, 8}, false},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, {8, 8, 8, 8}, true},
    {GL_UNSIGNED_INT_10_10_10_2, 4, {10, 10, 10, 2}, false},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, {10, 10, 10, 2}, true},
};

} // namespace

int values_per_pixel(GLenum format)
{
    switch (format) {
    case GL_RED:
    case GL_GREEN:
    case GL_BLUE:
    case GL_ALPHA:
    case GL_LUMINANCE:
        return 1;
    case GL_LUMINANCE_ALPHA:
        return 2;
    case GL_RGB:
    case GL_BGR:
        return 3;
    case GL_RGBA:
    case GL_BGRA:
        return 4;
    default:
        return 0;
    }
}

int bytes_per_value(GLenum type)
{
    switch (type) {
    case GL_UNSIGNED_BYTE:
    case GL_BYTE:
        return 1;
    case GL_UNSIGNED_SHORT:
    case GL_SHORT:
        return 2;
    case GL_UNSIGNED_INT:
    case GL_INT:
    case GL_FLOAT:
        return 4;
    default: {
        const PackedType* packed = find_packed_type(type);
        return packed ? packed->bytes : 0;
    }
    }
}

int bytes_per_pixel(GLenum format, GLenum type)
{
    return find_packed_type(type) ? bytes_per_value(type) : bytes_per_value(type) * values_per_pixel(format);
}

GLenum format_type_error(GLenum format, GLenum type)
{
    if (values_per_pixel(format) == 0 || bytes_per_value(type) == 0) {
        return GL_INVALID_ENUM;
    }
    const PackedType* packed = find_packed_type(type);
    if (!packed) {
        return GL_NO_ERROR;
    }
    const bool fits = packed->values() == 3 ? format == GL_RGB : format == GL_RGBA || format == GL_BGRA;
    return fits ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

std::uint8_t byte_of_bits(std::uint32_t value, int bits)
{
    if (bits >= 8) {
        const std::uint32_t greatest = (1u << bits) - 1;
        return static_cast<std::uint8_t>((value * 255 + greatest / 2) / greatest);
    }
    std::uint32_t byte = 0;
    for (int shift = 8 - bits; shift > -bits; shift -= bits) {
        byte |= shift >= 0 ? value << shift : value >> -shift;
    }
    return static_cast<std::uint8_t>(byte);
}

const PackedType* find_packed_type(GLenum type)
{
    for (const PackedType& packed : PACKED_TYPES) {
        if (packed.type == type) {
            return &packed;
        }
    }
    return nullptr;
}

} // namespace legacygl
