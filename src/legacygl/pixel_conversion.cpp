#include "legacygl/pixel_conversion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace legacygl {
namespace {

/// Where the bytes of a client image lie.
struct ClientLayout
{
    ClientLayout(const PixelStore& store, int width, GLenum format, GLenum type)
    {
        const auto element = static_cast<std::size_t>(bytes_per_value(type));
        pixel = element * values_per_pixel(format);
        const std::size_t length = store.row_length > 0 ? store.row_length : width;
        row = pixel * length;
        const auto alignment = static_cast<std::size_t>(store.alignment);
        if (element < alignment)
            row = (row + alignment - 1) / alignment * alignment;
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
    case GL_UNSIGNED_BYTE:
        return static_cast<float>(*p) / 255.0f;
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

std::uint8_t to_byte(float value)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

/// Reads one value as a byte; the common type is not sent through float.
std::uint8_t read_byte(GLenum type, const std::uint8_t* p)
{
    return type == GL_UNSIGNED_BYTE ? *p : to_byte(read_value(type, p));
}

void read_pixel(bool swap, GLenum format, GLenum type, const std::uint8_t* p, std::uint8_t out[4])
{
    const int size = bytes_per_value(type);
    const auto value = [&](int i) {
        std::uint8_t bytes[4];
        std::memcpy(bytes, p + i * size, static_cast<std::size_t>(size));
        if (swap)
            std::reverse(bytes, bytes + size);
        return read_byte(type, bytes);
    };
    out[0] = out[1] = out[2] = 0;
    out[3] = 255;
    switch (format) {
    case GL_RED:
        out[0] = value(0);
        break;
    case GL_GREEN:
        out[1] = value(0);
        break;
    case GL_BLUE:
        out[2] = value(0);
        break;
    case GL_ALPHA:
        out[3] = value(0);
        break;
    case GL_LUMINANCE:
    case GL_LUMINANCE_ALPHA:
        out[0] = out[1] = out[2] = value(0);
        if (format == GL_LUMINANCE_ALPHA)
            out[3] = value(1);
        break;
    case GL_BGR:
    case GL_BGRA:
        for (int i = 0; i < 3; ++i)
            out[i] = value(2 - i);
        if (format == GL_BGRA)
            out[3] = value(3);
        break;
    default:
        for (int i = 0; i < values_per_pixel(format); ++i)
            out[i] = value(i);
        break;
    }
}

/// Keeps what the base format keeps of a pixel, spread as the sampler returns it (OpenGL 1.5, table 3.15).
void keep_components(BaseFormat base, std::uint8_t p[4])
{
    switch (base) {
    case BaseFormat::alpha:
        p[0] = p[1] = p[2] = 0;
        break;
    case BaseFormat::luminance:
        p[1] = p[2] = p[0];
        p[3] = 255;
        break;
    case BaseFormat::luminance_alpha:
        p[1] = p[2] = p[0];
        break;
    case BaseFormat::intensity:
        p[1] = p[2] = p[3] = p[0];
        break;
    case BaseFormat::rgb:
        p[3] = 255;
        break;
    default:
        break;
    }
}

} // namespace

BaseFormat base_format(GLint internal_format)
{
    switch (internal_format) {
    case GL_ALPHA:
    case GL_ALPHA4:
    case GL_ALPHA8:
    case GL_ALPHA12:
    case GL_ALPHA16:
        return BaseFormat::alpha;
    case 1:
    case GL_LUMINANCE:
    case GL_LUMINANCE4:
    case GL_LUMINANCE8:
    case GL_LUMINANCE12:
    case GL_LUMINANCE16:
        return BaseFormat::luminance;
    case 2:
    case GL_LUMINANCE_ALPHA:
    case GL_LUMINANCE4_ALPHA4:
    case GL_LUMINANCE6_ALPHA2:
    case GL_LUMINANCE8_ALPHA8:
    case GL_LUMINANCE12_ALPHA4:
    case GL_LUMINANCE12_ALPHA12:
    case GL_LUMINANCE16_ALPHA16:
        return BaseFormat::luminance_alpha;
    case GL_INTENSITY:
    case GL_INTENSITY4:
    case GL_INTENSITY8:
    case GL_INTENSITY12:
    case GL_INTENSITY16:
        return BaseFormat::intensity;
    case 3:
    case GL_RGB:
    case GL_R3_G3_B2:
    case GL_RGB4:
    case GL_RGB5:
    case GL_RGB8:
    case GL_RGB10:
    case GL_RGB12:
    case GL_RGB16:
        return BaseFormat::rgb;
    case 4:
    case GL_RGBA:
    case GL_RGBA2:
    case GL_RGBA4:
    case GL_RGB5_A1:
    case GL_RGBA8:
    case GL_RGB10_A2:
    case GL_RGBA12:
    case GL_RGBA16:
        return BaseFormat::rgba;
    default:
        return BaseFormat::none;
    }
}

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
    default:
        return 0;
    }
}

std::size_t client_image_bytes(const PixelStore& store, int width, int height, GLenum format, GLenum type)
{
    if (width <= 0 || height <= 0)
        return 0;
    const ClientLayout layout(store, width, format, type);
    return layout.start + layout.row * (height - 1) + layout.pixel * width;
}

std::vector<std::uint8_t> unpack_texture(const PixelStore& store, int width, int height, GLenum format,
                                         GLenum type, BaseFormat base, const std::uint8_t* pixels)
{
    const ClientLayout layout(store, width, format, type);
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    std::uint8_t* to = rgba.data();
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* from = pixels + layout.start + layout.row * y;
        for (int x = 0; x < width; ++x, from += layout.pixel, to += 4) {
            read_pixel(store.swap_bytes, format, type, from, to);
            keep_components(base, to);
        }
    }
    return rgba;
}

void pack_pixels(const PixelStore& store, int width, int height, GLenum format, GLenum type,
                 const std::uint8_t* rgba, std::uint8_t* out)
{
    const ClientLayout layout(store, width, format, type);
    const int size = bytes_per_value(type);
    for (int y = 0; y < height; ++y) {
        std::uint8_t* to = out + layout.start + layout.row * y;
        for (int x = 0; x < width; ++x, rgba += 4, to += layout.pixel) {
            const auto write = [&](int i, std::uint8_t value) {
                if (type == GL_FLOAT) {
                    const float f = static_cast<float>(value) / 255.0f;
                    std::memcpy(to + i * size, &f, sizeof f);
                    if (store.swap_bytes)
                        std::reverse(to + i * size, to + (i + 1) * size);
                } else {
                    to[i] = value;
                }
            };
            switch (format) {
            case GL_RED:
            case GL_GREEN:
            case GL_BLUE:
            case GL_ALPHA:
                write(0, rgba[format - GL_RED]);
                break;
            case GL_BGR:
            case GL_BGRA:
                for (int i = 0; i < 3; ++i)
                    write(i, rgba[2 - i]);
                if (format == GL_BGRA)
                    write(3, rgba[3]);
                break;
            default:
                for (int i = 0; i < values_per_pixel(format); ++i)
                    write(i, rgba[i]);
                break;
            }
        }
    }
}

} // namespace legacygl
