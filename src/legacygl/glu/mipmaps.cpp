// gluBuild1DMipmaps, gluBuild2DMipmaps and their forms for some levels (GLU 1.3, 3.2).

#include "legacygl/glu/mipmap_filter.h"
#include "legacygl/glu/short_image.h"

#include <utility>

using namespace legacygl::glu;

namespace {

/// Returns the power of two nearest to a positive value, of two equally near ones the greater: 3 → 4, 5 → 4.
int nearest_power_of_two(int value)
{
    int power = 1;
    for (; value > 1; value /= 2, power *= 2) {
        if (value == 3) {
            return 4 * power;
        }
    }
    return power;
}

/// Returns the exponent of a power of two, and -1 of anything else.
int exponent(int value)
{
    for (int i = 0; i < 31; ++i) {
        if (value == 1 << i) {
            return i;
        }
    }
    return -1;
}

struct Size
{
    int width, height;
};

/// Returns the sides of a texture for an image: powers of two, halved until OpenGL takes them.
Size texture_size(int width, int height)
{
    GLint greatest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &greatest);
    Size size{nearest_power_of_two(width), nearest_power_of_two(height)};
    while (std::max(size.width, size.height) > std::max(greatest, 1)) {
        size = {std::max(1, size.width / 2), std::max(1, size.height / 2)};
    }
    return size;
}

/// What a texture is made of, and which of its levels are wanted.
struct Order
{
    GLenum target;
    GLint internal_format;
    GLenum format, type;
    int user_level; ///< The level that the image is.
    int base, last; ///< The levels given to OpenGL.

    bool wants(int level) const { return base <= level && level <= last; }
    bool is_legal(int levels) const
    {
        return base >= 0 && base >= user_level && last >= base && last <= levels;
    }
};

/// A pixel of a packed type, and its components as fractions, which are what is averaged.
template <class T> class PackedPixels
{
public:
    PackedPixels(const PackedType& type, int width, int height, const std::vector<T>& pixels)
        : type_(&type), image_(width, height, type.components)
    {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            unpack_pixel(type, pixels[i], &image_.values[i * type.components]);
        }
    }
    std::vector<T> pixels() const
    {
        std::vector<T> out;
        for (std::size_t i = 0; i < image_.values.size(); i += type_->components) {
            out.push_back(static_cast<T>(pack_pixel(*type_, &image_.values[i])));
        }
        return out;
    }
    int width() const { return image_.width; }
    int height() const { return image_.height; }
    /// What is kept between levels are pixels: each level is packed and unpacked again.
    PackedPixels halved() const { return repacked(legacygl::glu::halved(image_)); }
    PackedPixels scaled(Size to) const
    {
        return repacked(legacygl::glu::scaled(image_, to.width, to.height, LastRow::whole));
    }

private:
    PackedPixels(const PackedType& type, TypedImage<float> image) : type_(&type), image_(std::move(image)) {}
    PackedPixels repacked(TypedImage<float> image) const
    {
        const PackedPixels rounded(*type_, std::move(image));
        return {*type_, rounded.width(), rounded.height(), rounded.pixels()};
    }

    const PackedType* type_;
    TypedImage<float> image_;
};

/// The same for a type with a value for each component.
template <class T> class PlainPixels
{
public:
    explicit PlainPixels(TypedImage<T> image) : image_(std::move(image)) {}
    const std::vector<T>& pixels() const { return image_.values; }
    int width() const { return image_.width; }
    int height() const { return image_.height; }
    PlainPixels halved() const { return PlainPixels(legacygl::glu::halved(image_)); }
    PlainPixels scaled(Size to) const
    {
        return PlainPixels(legacygl::glu::scaled(image_, to.width, to.height, LastRow::cut));
    }

private:
    TypedImage<T> image_;
};

template <class Pixels> void give_levels(const Order& order, Pixels image, Size size)
{
    if (image.width() != size.width || image.height() != size.height) {
        image = image.scaled(size);
    }
    for (int level = order.user_level;; ++level) {
        if (order.wants(level)) {
            glTexImage2D(order.target, level, order.internal_format, image.width(), image.height(), 0,
                         order.format, order.type, image.pixels().data());
        }
        if (image.width() == 1 && image.height() == 1) {
            return;
        }
        image = image.halved();
    }
}

template <class T>
void build_plain(const PixelStoreModes& modes, const Order& order, Size given, Size size, const void* data)
{
    const int components = components_of(order.format);
    give_levels(
        order,
        PlainPixels(TypedImage<T>(given.width, given.height, components,
                                  read_values<T>(modes, given.width, given.height, components, data))),
        size);
}

template <class T>
void build_packed(const PixelStoreModes& modes, const Order& order, const PackedType& type, Size given,
                  Size size, const void* data)
{
    give_levels(order,
                PackedPixels<T>(type, given.width, given.height,
                                read_values<T>(modes, given.width, given.height, 1, data)),
                size);
}

void build_2d(const Order& order, Size given, Size size, const void* data)
{
    const PixelStoreModes modes = PixelStoreModes::unpacking();
    const TightUnpacking tight(modes);
    switch (order.type) {
    case GL_UNSIGNED_BYTE:
        return build_plain<GLubyte>(modes, order, given, size, data);
    case GL_BYTE:
        return build_plain<GLbyte>(modes, order, given, size, data);
    case GL_UNSIGNED_SHORT:
        return build_plain<GLushort>(modes, order, given, size, data);
    case GL_SHORT:
        return build_plain<GLshort>(modes, order, given, size, data);
    case GL_UNSIGNED_INT:
        return build_plain<GLuint>(modes, order, given, size, data);
    case GL_INT:
        return build_plain<GLint>(modes, order, given, size, data);
    case GL_FLOAT:
        return build_plain<GLfloat>(modes, order, given, size, data);
    default:
        break;
    }
    const PackedType& packed = *find_packed_type(order.type);
    if (packed.bytes == 1) {
        build_packed<GLubyte>(modes, order, packed, given, size, data);
    } else if (packed.bytes == 2) {
        build_packed<GLushort>(modes, order, packed, given, size, data);
    } else {
        build_packed<GLuint>(modes, order, packed, given, size, data);
    }
}

void build_1d(const Order& order, int given, int size, const void* data)
{
    const PixelStoreModes modes = PixelStoreModes::unpacking();
    const TightUnpacking tight(modes);
    std::vector<GLushort> image = read_shorts(modes, given, 1, order.format, order.type, data);
    int width = given;
    for (int level = order.user_level;; ++level, size /= 2) {
        if (width != size) {
            image = scale_shorts(image, components_of(order.format), width, 1, size, 1);
        }
        width = size;
        if (order.wants(level)) {
            glTexImage1D(order.target, level, order.internal_format, width, 0, order.format,
                         GL_UNSIGNED_SHORT, image.data());
        }
        if (size == 1) {
            return;
        }
    }
}

/// Returns 0 or the error that an image is refused with.
GLenum check(GLenum format, GLenum type, int width, int height)
{
    if (format == GL_STENCIL_INDEX) {
        return GLU_INVALID_ENUM;
    }
    if (const GLenum error = check_format_and_type(format, type)) {
        return error;
    }
    return width < 1 || height < 1 ? GLU_INVALID_VALUE : 0;
}

} // namespace

GLint gluBuild1DMipmaps(GLenum target, GLint internalFormat, GLsizei width, GLenum format, GLenum type,
                        const void* data)
{
    if (const GLenum error = check(format, type, width, 1)) {
        return static_cast<GLint>(error);
    }
    const int size = texture_size(width, 1).width;
    build_1d({target, internalFormat, format, type, 0, 0, exponent(size)}, width, size, data);
    return 0;
}

GLint gluBuild1DMipmapLevels(GLenum target, GLint internalFormat, GLsizei width, GLenum format, GLenum type,
                             GLint level, GLint base, GLint max, const void* data)
{
    if (const GLenum error = check(format, type, width, 1)) {
        return static_cast<GLint>(error);
    }
    const Order order{target, internalFormat, format, type, level, base, max};
    if (exponent(width) < 0 || !order.is_legal(exponent(width) + level)) {
        return GLU_INVALID_VALUE;
    }
    build_1d(order, width, width, data);
    return 0;
}

GLint gluBuild2DMipmaps(GLenum target, GLint internalFormat, GLsizei width, GLsizei height, GLenum format,
                        GLenum type, const void* data)
{
    if (const GLenum error = check(format, type, width, height)) {
        return static_cast<GLint>(error);
    }
    const Size size = texture_size(width, height);
    build_2d({target, internalFormat, format, type, 0, 0, exponent(std::max(size.width, size.height))},
             {width, height}, size, data);
    return 0;
}

GLint gluBuild2DMipmapLevels(GLenum target, GLint internalFormat, GLsizei width, GLsizei height,
                             GLenum format, GLenum type, GLint level, GLint base, GLint max, const void* data)
{
    if (const GLenum error = check(format, type, width, height)) {
        return static_cast<GLint>(error);
    }
    const Order order{target, internalFormat, format, type, level, base, max};
    // One side need not be a power of two, as long as the levels wanted end before the other side's.
    const int levels = std::max(exponent(width), exponent(height));
    if (levels < 0 || !order.is_legal(levels + level)) {
        return GLU_INVALID_VALUE;
    }
    build_2d(order, {width, height}, {width, height}, data);
    return 0;
}
