#pragma once

#include <GL/gl.h>

#include <array>
#include <cstdint>

namespace legacygl {

/// Returns how many values a pixel of the format has (OpenGL 1.5, table 3.6); 0: not supported.
int values_per_pixel(GLenum format);

/// Returns the bytes of one value of the type, or of the whole pixel for a packed type; 0: not supported.
int bytes_per_value(GLenum type);

/// Returns the bytes of a pixel; format and type have no error.
int bytes_per_pixel(GLenum format, GLenum type);

/// Returns what is wrong with a client image of that format and type, or GL_NO_ERROR: GL_INVALID_ENUM for
/// unknown ones, GL_INVALID_OPERATION for a packed type that does not hold the format's values (OpenGL 1.5,
/// 3.6.4).
GLenum format_type_error(GLenum format, GLenum type);

/// How a packed type holds the values of a pixel (OpenGL 1.5, table 3.8).
struct PackedType
{
    GLenum type;
    int bytes;
    std::array<int, 4> bits; ///< Of the first value, the second …; 0: there are but three.
    bool reversed;           ///< The first value is in the least significant bits.
    int values() const { return bits[3] == 0 ? 3 : 4; }
};

/// Returns a fraction given by so many bits (1 to 10) as a byte. Fewer than 8 bits are repeated, as Mesa
/// does, which is beside the nearest byte for some fractions of 5 and 6 bits.
std::uint8_t byte_of_bits(std::uint32_t value, int bits);

/// Returns the packed type, or null when the type holds one value.
const PackedType* find_packed_type(GLenum type);

} // namespace legacygl
