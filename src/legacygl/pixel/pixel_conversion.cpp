#include "legacygl/pixel/pixel_conversion.h"

#include "legacygl/pixel/client_bitmap.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace legacygl {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

/// Where the bytes of a client image lie.
struct ClientLayout
{
    ClientLayout(const PixelStore& store, int width, GLenum format, GLenum type)
    {
        const auto element = static_cast<std::size_t>(bytes_per_value(type));
        pixel = static_cast<std::size_t>(bytes_per_pixel(format, type));
        const std::size_t length = store.row_length > 0 ? store.row_length : width;
        row = pixel * length;
        const auto alignment = static_cast<std::size_t>(store.alignment);
        if (element < alignment) {
            row = (row + alignment - 1) / alignment * alignment;
        }
        start = row * store.skip_rows + pixel * store.skip_pixels;
    }
    std::size_t pixel, row, start;
};

/// Reads one value as a fraction (OpenGL 1.5, table 2.9).
float read_value(GLenum type, const std::uint8_t* p)
{
    const auto load = [p](auto value) {
        std::memcpy(&value, p, sizeof value);
        return value;
    };
    switch (type) {
    case GL_BYTE:
        return (2.0f * static_cast<float>(load(GLbyte{})) + 1.0f) / 255.0f;
    case GL_UNSIGNED_SHORT:
        return static_cast<float>(load(GLushort{})) / 65535.0f;
    case GL_SHORT:
        return (2.0f * static_cast<float>(load(GLshort{})) + 1.0f) / 65535.0f;
    case GL_UNSIGNED_INT:
        return static_cast<float>(static_cast<double>(load(GLuint{})) / 4294967295.0);
    case GL_INT:
        return static_cast<float>((2.0 * static_cast<double>(load(GLint{})) + 1.0) / 4294967295.0);
    default:
        return load(GLfloat{});
    }
}

/// Writes one value (OpenGL 1.5, table 4.6, with the greatest signed integer for 1, as Mesa does).
void write_value(GLenum type, std::uint8_t value, std::uint8_t* to)
{
    const double fraction = static_cast<double>(value) / 255.0;
    const auto store = [&](auto typed, double greatest) {
        typed = static_cast<decltype(typed)>(std::floor(fraction * greatest + 0.5));
        std::memcpy(to, &typed, sizeof typed);
    };
    switch (type) {
    case GL_BYTE:
        return store(GLbyte{}, 127.0);
    case GL_UNSIGNED_SHORT:
        return store(GLushort{}, 65535.0);
    case GL_SHORT:
        return store(GLshort{}, 32767.0);
    case GL_UNSIGNED_INT:
        return store(GLuint{}, 4294967295.0);
    case GL_INT:
        return store(GLint{}, 2147483647.0);
    case GL_FLOAT: {
        const float f = static_cast<float>(value) * (1.0f / 255.0f);
        std::memcpy(to, &f, sizeof f);
        return;
    }
    default:
        *to = value;
    }
}

std::uint8_t to_byte(float value)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

/// Copies bytes, the last first if they are to be swapped.
void copy_value(bool swap, const std::uint8_t* from, std::uint8_t* to, int size)
{
    swap ? std::reverse_copy(from, from + size, to) : std::copy(from, from + size, to);
}

/// Returns how far to the left value i of a packed pixel stands.
int shift_of(const PackedType& packed, int i)
{
    int shift = 0;
    for (int k = 0; k < packed.values(); ++k) {
        if (packed.reversed ? k < i : k > i) {
            shift += packed.bits[k];
        }
    }
    return shift;
}

/// Reads the values of a pixel, in the order in which the client gives them, as bytes.
void read_values(bool swap, GLenum format, GLenum type, const PackedType* packed, const std::uint8_t* p,
                 Rgba& values)
{
    const int size = bytes_per_value(type);
    std::uint8_t bytes[4] = {};
    if (packed) {
        copy_value(swap, p, bytes, size);
        std::uint32_t word = 0;
        for (int i = size; i-- > 0;) {
            word = word << 8 | bytes[i];
        }
        for (int i = 0; i < packed->values(); ++i) {
            const std::uint32_t greatest = (1u << packed->bits[i]) - 1;
            const std::uint32_t value = word >> shift_of(*packed, i) & greatest;
            values[i] = byte_of_bits(value, packed->bits[i]);
        }
        return;
    }
    for (int i = 0; i < values_per_pixel(format); ++i) {
        copy_value(swap, p + i * size, bytes, size);
        // The common type is not sent through float.
        values[i] = type == GL_UNSIGNED_BYTE ? bytes[0] : to_byte(read_value(type, bytes));
    }
}

/// Puts the values that a client gives where they belong (OpenGL 1.5, table 3.6).
Rgba spread(GLenum format, const Rgba& v)
{
    switch (format) {
    case GL_RED:
        return {v[0], 0, 0, 255};
    case GL_GREEN:
        return {0, v[0], 0, 255};
    case GL_BLUE:
        return {0, 0, v[0], 255};
    case GL_ALPHA:
        return {0, 0, 0, v[0]};
    case GL_LUMINANCE:
        return {v[0], v[0], v[0], 255};
    case GL_LUMINANCE_ALPHA:
        return {v[0], v[0], v[0], v[1]};
    case GL_RGB:
        return {v[0], v[1], v[2], 255};
    case GL_BGR:
        return {v[2], v[1], v[0], 255};
    case GL_BGRA:
        return {v[2], v[1], v[0], v[3]};
    default:
        return v;
    }
}

/// Takes the values that a client wants out of a pixel, in its order.
Rgba gather(GLenum format, const std::uint8_t* p, ToLuminance how)
{
    const int sum = std::min(255, p[0] + p[1] + p[2]);
    const auto luminance = how == ToLuminance::sum ? static_cast<std::uint8_t>(sum) : p[0];
    switch (format) {
    case GL_RED:
    case GL_GREEN:
    case GL_BLUE:
    case GL_ALPHA:
        return {p[format - GL_RED]};
    case GL_LUMINANCE:
    case GL_LUMINANCE_ALPHA:
        return {luminance, p[3]};
    case GL_BGR:
    case GL_BGRA:
        return {p[2], p[1], p[0], p[3]};
    default:
        return {p[0], p[1], p[2], p[3]};
    }
}

void write_packed(const PackedType& packed, const Rgba& values, std::uint8_t* to)
{
    std::uint32_t word = 0;
    for (int i = 0; i < packed.values(); ++i) {
        const std::uint32_t greatest = (1u << packed.bits[i]) - 1;
        word |= (values[i] * greatest + 127) / 255 << shift_of(packed, i);
    }
    for (int i = 0; i < packed.bytes; ++i) {
        to[i] = static_cast<std::uint8_t>(word >> 8 * i);
    }
}

void write_pixel(bool swap, GLenum format, GLenum type, const PackedType* packed, const Rgba& values,
                 std::uint8_t* to)
{
    const int size = bytes_per_value(type);
    std::uint8_t bytes[4] = {};
    if (packed) {
        write_packed(*packed, values, bytes);
        return copy_value(swap, bytes, to, size);
    }
    for (int i = 0; i < values_per_pixel(format); ++i) {
        write_value(type, values[i], bytes);
        copy_value(swap, bytes, to + i * size, size);
    }
}

/// Writes a number as it is.
void write_number(GLenum type, double number, std::uint8_t* to)
{
    const auto store = [&](auto typed) {
        typed = static_cast<decltype(typed)>(number);
        std::memcpy(to, &typed, sizeof typed);
    };
    switch (type) {
    case GL_BYTE:
        return store(GLbyte{});
    case GL_UNSIGNED_SHORT:
        return store(GLushort{});
    case GL_SHORT:
        return store(GLshort{});
    case GL_UNSIGNED_INT:
        return store(GLuint{});
    case GL_INT:
        return store(GLint{});
    case GL_FLOAT:
        return store(GLfloat{});
    default:
        return store(GLubyte{});
    }
}

/// Writes an image of one number a pixel.
template <class Number>
void pack_numbers(const PixelStore& store, int width, int height, GLenum type, Number number,
                  std::uint8_t* out)
{
    const ClientLayout layout(store, width, GL_LUMINANCE, type);
    std::size_t pixel = 0;
    for (int y = 0; y < height; ++y) {
        std::uint8_t* to = out + layout.start + layout.row * y;
        for (int x = 0; x < width; ++x, to += layout.pixel) {
            std::uint8_t bytes[4] = {};
            write_number(type, number(pixel++), bytes);
            copy_value(store.swap_bytes, bytes, to, bytes_per_value(type));
        }
    }
}

/// Returns what stands for a depth in the type (OpenGL 1.5, table 4.6).
double depth_in(GLenum type, std::uint32_t steps)
{
    const double depth = static_cast<double>(steps) / 16777215.0;
    switch (type) {
    case GL_FLOAT:
        return depth;
    case GL_UNSIGNED_INT:
        return static_cast<double>(steps << 8 | steps >> 16);
    case GL_UNSIGNED_SHORT:
        return std::floor(depth * 65535.0 + 0.5);
    case GL_UNSIGNED_BYTE:
        return std::floor(depth * 255.0);
    case GL_INT:
        return std::floor(static_cast<double>(static_cast<float>(depth)) * 2147483647.0);
    case GL_SHORT:
        return std::floor((std::floor(depth * 65535.0) - 1.0) / 2.0);
    default:
        return std::floor((std::floor(depth * 255.0) - 1.0) / 2.0);
    }
}

} // namespace

std::size_t client_image_bytes(const PixelStore& store, int width, int height, GLenum format, GLenum type)
{
    if (width <= 0 || height <= 0 || format_type_error(format, type) != GL_NO_ERROR) {
        return 0;
    }
    const ClientLayout layout(store, width, format, type);
    return layout.start + layout.row * (height - 1) + layout.pixel * width;
}

std::vector<std::uint8_t> unpack_pixels(const PixelStore& store, int width, int height, GLenum format,
                                        GLenum type, const std::uint8_t* pixels)
{
    const ClientLayout layout(store, width, format, type);
    const PackedType* packed = find_packed_type(type);
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    std::uint8_t* to = rgba.data();
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* from = pixels + layout.start + layout.row * y;
        for (int x = 0; x < width; ++x, from += layout.pixel, to += 4) {
            Rgba values{};
            read_values(store.swap_bytes, format, type, packed, from, values);
            const Rgba pixel = spread(format, values);
            std::copy(pixel.begin(), pixel.end(), to);
        }
    }
    return rgba;
}

void pack_pixels(const PixelStore& store, int width, int height, GLenum format, GLenum type,
                 std::span<const std::uint8_t> rgba, ToLuminance luminance, std::uint8_t* out)
{
    const ClientLayout layout(store, width, format, type);
    const PackedType* packed = find_packed_type(type);
    const std::uint8_t* from = rgba.data();
    for (int y = 0; y < height; ++y) {
        std::uint8_t* to = out + layout.start + layout.row * y;
        for (int x = 0; x < width; ++x, from += 4, to += layout.pixel) {
            write_pixel(store.swap_bytes, format, type, packed, gather(format, from, luminance), to);
        }
    }
}

void pack_depths(const PixelStore& store, int width, int height, GLenum type,
                 std::span<const std::uint32_t> depths, std::uint8_t* out)
{
    pack_numbers(store, width, height, type, [&](std::size_t i) { return depth_in(type, depths[i]); }, out);
}

void pack_stencils(const PixelStore& store, int width, int height, GLenum type,
                   std::span<const std::uint8_t> values, std::uint8_t* out)
{
    if (type == GL_BITMAP) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            write_bit(store, width, static_cast<int>(i) % width, static_cast<int>(i) / width, values[i] & 1,
                      out);
        }
        return;
    }
    pack_numbers(
        store, width, height, type, [&](std::size_t i) { return static_cast<double>(values[i]); }, out);
}

} // namespace legacygl
