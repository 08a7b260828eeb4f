// Images of 16-bit values, in which libGLU scales whatever gluScaleImage and gluBuild1DMipmaps are given.
//
// Every conversion here is libGLU's, also where it is coarse (signed values are "roughly" doubled): its
// results are compared with ours to the bit.

#include "legacygl/glu/short_image.h"

#include <cmath>
#include <type_traits>
#include <utility>

namespace legacygl::glu {
namespace {

bool is_index(GLenum format)
{
    return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX;
}

/// Converts to an int, of which the low half stays.
GLushort truncated(double value)
{
    return static_cast<GLushort>(to_int(value));
}

GLushort to_short(GLubyte value)
{
    return static_cast<GLushort>(value * 257);
}
GLushort to_short(GLbyte value)
{
    return static_cast<GLushort>(value * 516);
}
GLushort to_short(GLushort value)
{
    return value;
}
GLushort to_short(GLshort value)
{
    return static_cast<GLushort>(value * 2);
}
GLushort to_short(GLuint value)
{
    return static_cast<GLushort>(value >> 16);
}
GLushort to_short(GLint value)
{
    return static_cast<GLushort>(value >> 15);
}
GLushort to_short(GLfloat value)
{
    return truncated(static_cast<double>(65535 * value));
}

template <class T> T from_short(GLushort value);
template <> GLubyte from_short(GLushort value)
{
    return static_cast<GLubyte>(value >> 8);
}
template <> GLbyte from_short(GLushort value)
{
    return static_cast<GLbyte>(value >> 9);
}
template <> GLushort from_short(GLushort value)
{
    return value;
}
template <> GLshort from_short(GLushort value)
{
    return static_cast<GLshort>(value >> 1);
}
template <> GLuint from_short(GLushort value)
{
    return value * 65537u;
}
template <> GLint from_short(GLushort value)
{
    return static_cast<GLint>(value * 65537u / 2);
}
template <> GLfloat from_short(GLushort value)
{
    return value / 65535.0f;
}

/// One image's place and form in client memory.
struct Client
{
    const PixelStoreModes& modes;
    int width, height;
    GLenum format;
};

template <class T> std::vector<GLushort> read(const Client& c, const void* data)
{
    const std::vector<T> values = read_values<T>(c.modes, c.width, c.height, components_of(c.format), data);
    std::vector<GLushort> image(values.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!is_index(c.format)) {
            image[i] = to_short(values[i]);
        } else if constexpr (std::is_floating_point_v<T>) {
            image[i] = truncated(static_cast<double>(values[i]));
        } else {
            image[i] = static_cast<GLushort>(values[i]);
        }
    }
    return image;
}

template <class T>
std::vector<GLushort> read_packed(const Client& c, const PackedType& type, const void* data)
{
    std::vector<GLushort> image;
    for (const T pixel : read_values<T>(c.modes, c.width, c.height, 1, data)) {
        std::array<float, 4> components;
        unpack_pixel(type, pixel, components.data());
        for (int i = 0; i < type.components; ++i) {
            image.push_back(truncated(static_cast<double>(components[i] * 65535)));
        }
    }
    return image;
}

template <class T> void write(const Client& c, const std::vector<GLushort>& image, void* data)
{
    std::vector<T> values(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        values[i] = is_index(c.format) ? static_cast<T>(image[i]) : from_short<T>(image[i]);
    }
    write_values(c.modes, c.width, c.height, components_of(c.format), std::move(values), data);
}

template <class T>
void write_packed(const Client& c, const PackedType& type, const std::vector<GLushort>& image, void* data)
{
    std::vector<T> pixels;
    for (std::size_t i = 0; i < image.size(); i += type.components) {
        std::array<float, 4> components;
        for (int k = 0; k < type.components; ++k) {
            components[k] = static_cast<float>(image[i + k] / 65535.0);
        }
        pixels.push_back(static_cast<T>(pack_pixel(type, components.data())));
    }
    write_values(c.modes, c.width, c.height, 1, std::move(pixels), data);
}

/// Calls visit with a value of the component type, or of the unsigned type as large as a packed pixel.
template <class Visit> void with_type(GLenum type, Visit visit)
{
    switch (type) {
    case GL_UNSIGNED_BYTE:
        return visit(GLubyte{});
    case GL_BYTE:
        return visit(GLbyte{});
    case GL_UNSIGNED_SHORT:
        return visit(GLushort{});
    case GL_SHORT:
        return visit(GLshort{});
    case GL_UNSIGNED_INT:
        return visit(GLuint{});
    case GL_INT:
        return visit(GLint{});
    case GL_FLOAT:
        return visit(GLfloat{});
    default:
        switch (bytes_of(type)) {
        case 1:
            return visit(GLubyte{});
        case 2:
            return visit(GLushort{});
        default:
            return visit(GLuint{});
        }
    }
}

/// The stretch of input that an output value covers along one side.
struct Stretch
{
    Stretch(int index, float step, bool shrinks)
    {
        const auto middle = static_cast<float>(static_cast<double>(step) * (index + 0.5));
        low = shrinks ? middle - step / 2 : static_cast<float>(static_cast<double>(middle) - 0.5);
        high = shrinks ? middle + step / 2 : static_cast<float>(static_cast<double>(middle) + 0.5);
    }
    /// Calls visit(input value's index, covered part of it) along the stretch, around an input of that size.
    template <class Visit> void each(int size, Visit visit) const
    {
        float at = low;
        for (int whole = static_cast<int>(std::floor(at)); at < high; at = static_cast<float>(++whole)) {
            const float end = high < static_cast<float>(whole + 1) ? high : static_cast<float>(whole + 1);
            visit((whole + size) % size, end - at);
        }
    }
    float low, high;
};

} // namespace

std::vector<GLushort> read_shorts(const PixelStoreModes& modes, int width, int height, GLenum format,
                                  GLenum type, const void* data)
{
    const Client client{modes, width, height, format};
    const PackedType* packed = find_packed_type(type);
    std::vector<GLushort> image;
    with_type(type, [&]<class T>(T) {
        if constexpr (std::is_unsigned_v<T>) {
            if (packed) {
                image = read_packed<T>(client, *packed, data);
                return;
            }
        }
        image = read<T>(client, data);
    });
    return image;
}

void write_shorts(const PixelStoreModes& modes, int width, int height, GLenum format, GLenum type,
                  const std::vector<GLushort>& image, void* data)
{
    const Client client{modes, width, height, format};
    const PackedType* packed = find_packed_type(type);
    with_type(type, [&]<class T>(T) {
        if constexpr (std::is_unsigned_v<T>) {
            if (packed) {
                return write_packed<T>(client, *packed, image, data);
            }
        }
        write<T>(client, image, data);
    });
}

std::vector<GLushort> scale_shorts(const std::vector<GLushort>& image, int components, int width, int height,
                                   int new_width, int new_height)
{
    std::vector<GLushort> out;
    out.reserve(static_cast<std::size_t>(new_width) * new_height * components);
    const auto at = [&](int x, int y) {
        return image.data() + (static_cast<std::size_t>(y) * width + x) * components;
    };
    if (width == 2 * new_width && height == 2 * new_height) {
        for (int y = 0; y < height; y += 2) {
            for (int x = 0; x < width; x += 2) {
                for (int k = 0; k < components; ++k) {
                    out.push_back(static_cast<GLushort>(
                        (at(x, y)[k] + at(x + 1, y)[k] + at(x, y + 1)[k] + at(x + 1, y + 1)[k] + 2) / 4));
                }
            }
        }
        return out;
    }
    const float step_x = static_cast<float>(width) / static_cast<float>(new_width);
    const float step_y = static_cast<float>(height) / static_cast<float>(new_height);
    for (int row = 0; row < new_height; ++row) {
        const Stretch rows(row, step_y, height > new_height);
        for (int column = 0; column < new_width; ++column) {
            const Stretch columns(column, step_x, width > new_width);
            std::array<float, 4> totals{};
            float area = 0;
            rows.each(height, [&](int y, float part_y) {
                columns.each(width, [&](int x, float part_x) {
                    const float part = part_x * part_y;
                    area += part;
                    for (int k = 0; k < components; ++k) {
                        totals[k] += static_cast<float>(at(x, y)[k]) * part;
                    }
                });
            });
            for (int k = 0; k < components; ++k) {
                out.push_back(truncated((static_cast<double>(totals[k]) + 0.5) / static_cast<double>(area)));
            }
        }
    }
    return out;
}

} // namespace legacygl::glu
