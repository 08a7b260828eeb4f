#pragma once

#include <GL/gl.h>
#include <GL/glu.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace legacygl::glu {

/// How images lie in client memory: the pixel store of unpacking or packing, read from OpenGL.
struct PixelStoreModes
{
    static PixelStoreModes unpacking();
    static PixelStoreModes packing();

    GLint alignment, row_length, skip_rows, skip_pixels, swap_bytes;
};

/// Sets the pixel store for images without gaps while it lives.
class TightUnpacking
{
public:
    explicit TightUnpacking(const PixelStoreModes& before);
    ~TightUnpacking();
    TightUnpacking(const TightUnpacking&) = delete;
    TightUnpacking& operator=(const TightUnpacking&) = delete;

private:
    PixelStoreModes before_;
};

/// A type that packs a pixel's components into the bits of one value (OpenGL 1.5, table 3.8).
struct PackedType
{
    GLenum type;
    int bytes;               ///< Of a pixel.
    int components;          ///< 3 or 4.
    std::array<int, 4> bits; ///< Of each component, the first in the highest bits.
    bool reversed;           ///< The first in the lowest bits.
};

/// Returns the packed type of that name, or null when the type is another.
const PackedType* find_packed_type(GLenum type);
/// Reads a packed pixel's components as fractions, and writes them.
void unpack_pixel(const PackedType& type, std::uint32_t pixel, float* components);
std::uint32_t pack_pixel(const PackedType& type, const float* components);

/// Returns 0 when GLU scales images of the format and type, or the GLU error they are refused with.
GLenum check_format_and_type(GLenum format, GLenum type);

/// Returns how many components a pixel of the format has.
int components_of(GLenum format);

/// Returns how many bytes a component of the type has, or a pixel of a packed type.
int bytes_of(GLenum type);

/// Cuts a number off to an int; what no int can be becomes the least, as on the machines libGLU runs on.
inline GLint to_int(double value)
{
    return value > -2147483649.0 && value < 2147483648.0 ? static_cast<GLint>(value)
                                                         : std::numeric_limits<GLint>::min();
}

/// Returns the value in another byte order.
template <class T> T swapped(T value)
{
    std::array<std::uint8_t, sizeof(T)> bytes, turned;
    std::memcpy(bytes.data(), &value, sizeof value);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        turned[i] = bytes[sizeof(T) - 1 - i];
    }
    std::memcpy(&value, turned.data(), sizeof value);
    return value;
}

/// Where the rows of a client image lie.
struct ImageLayout
{
    /// values_per_pixel: components, or 1 of a packed type.
    ImageLayout(const PixelStoreModes& modes, int width, int values_per_pixel, int bytes_per_value)
        : row(static_cast<std::size_t>(modes.row_length > 0 ? modes.row_length : width) * values_per_pixel *
              bytes_per_value)
    {
        const auto alignment = static_cast<std::size_t>(modes.alignment);
        row = (row + alignment - 1) / alignment * alignment;
        start = row * modes.skip_rows +
                static_cast<std::size_t>(modes.skip_pixels) * values_per_pixel * bytes_per_value;
    }
    std::size_t row, start;
};

/// Reads an image's values of type T into rows without gaps.
template <class T>
std::vector<T> read_values(const PixelStoreModes& modes, int width, int height, int values_per_pixel,
                           const void* data)
{
    const ImageLayout layout(modes, width, values_per_pixel, sizeof(T));
    const std::size_t count = static_cast<std::size_t>(width) * values_per_pixel;
    std::vector<T> values(count * height);
    for (int y = 0; y < height; ++y) {
        std::memcpy(&values[count * y],
                    static_cast<const std::uint8_t*>(data) + layout.start + layout.row * y,
                    count * sizeof(T));
    }
    if (modes.swap_bytes) {
        for (T& value : values) {
            value = swapped(value);
        }
    }
    return values;
}

/// Writes rows without gaps as the modes want them.
template <class T>
void write_values(const PixelStoreModes& modes, int width, int height, int values_per_pixel,
                  std::vector<T> values, void* data)
{
    if (modes.swap_bytes) {
        for (T& value : values) {
            value = swapped(value);
        }
    }
    const ImageLayout layout(modes, width, values_per_pixel, sizeof(T));
    const std::size_t count = static_cast<std::size_t>(width) * values_per_pixel;
    for (int y = 0; y < height; ++y) {
        std::memcpy(static_cast<std::uint8_t*>(data) + layout.start + layout.row * y, &values[count * y],
                    count * sizeof(T));
    }
}

} // namespace legacygl::glu
