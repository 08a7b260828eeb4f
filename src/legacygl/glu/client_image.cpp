#include "legacygl/glu/client_image.h"

namespace legacygl::glu {
namespace {

GLint get(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

/// Changes what differs.
void set(const PixelStoreModes& from, const PixelStoreModes& to)
{
    const auto change = [](GLenum name, GLint before, GLint value) {
        if (before != value) {
            glPixelStorei(name, value);
        }
    };
    change(GL_UNPACK_ALIGNMENT, from.alignment, to.alignment);
    change(GL_UNPACK_ROW_LENGTH, from.row_length, to.row_length);
    change(GL_UNPACK_SKIP_ROWS, from.skip_rows, to.skip_rows);
    change(GL_UNPACK_SKIP_PIXELS, from.skip_pixels, to.skip_pixels);
    change(GL_UNPACK_SWAP_BYTES, from.swap_bytes, to.swap_bytes);
}

constexpr PackedType PACKED_TYPES[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, 3, {3, 3, 2, 0}, false},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, 3, {3, 3, 2, 0}, true},
    {GL_UNSIGNED_SHORT_5_6_5, 2, 3, {5, 6, 5, 0}, false},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, 3, {5, 6, 5, 0}, true},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, 4, {4, 4, 4, 4}, false},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, 4, {4, 4, 4, 4}, true},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, 4, {5, 5, 5, 1}, false},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, 4, {5, 5, 5, 1}, true},
    {GL_UNSIGNED_INT_8_8_8_8, 4, 4, {8, 8, 8, 8}, false},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, 4, {8, 8, 8, 8}, true},
    {GL_UNSIGNED_INT_10_10_10_2, 4, 4, {10, 10, 10, 2}, false},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4, {10, 10, 10, 2}, true},
};

/// Calls visit(component, shift, greatest value) for each component of a packed type.
template <class Visit> void visit_components(const PackedType& type, Visit visit)
{
    int shift = type.reversed ? 0 : 8 * type.bytes;
    for (int i = 0; i < type.components; ++i) {
        if (!type.reversed) {
            shift -= type.bits[i];
        }
        visit(i, shift, (1u << type.bits[i]) - 1);
        if (type.reversed) {
            shift += type.bits[i];
        }
    }
}

} // namespace

PixelStoreModes PixelStoreModes::unpacking()
{
    return {get(GL_UNPACK_ALIGNMENT), get(GL_UNPACK_ROW_LENGTH), get(GL_UNPACK_SKIP_ROWS),
            get(GL_UNPACK_SKIP_PIXELS), get(GL_UNPACK_SWAP_BYTES)};
}

PixelStoreModes PixelStoreModes::packing()
{
    return {get(GL_PACK_ALIGNMENT), get(GL_PACK_ROW_LENGTH), get(GL_PACK_SKIP_ROWS), get(GL_PACK_SKIP_PIXELS),
            get(GL_PACK_SWAP_BYTES)};
}

TightUnpacking::TightUnpacking(const PixelStoreModes& before) : before_(before)
{
    set(before_, {1, 0, 0, 0, GL_FALSE});
}

TightUnpacking::~TightUnpacking()
{
    set({1, 0, 0, 0, GL_FALSE}, before_);
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

void unpack_pixel(const PackedType& type, std::uint32_t pixel, float* components)
{
    visit_components(type, [&](int i, int shift, std::uint32_t greatest) {
        const std::uint32_t value = pixel >> shift & greatest;
        components[i] = static_cast<float>(static_cast<double>(value) / greatest);
    });
}

std::uint32_t pack_pixel(const PackedType& type, const float* components)
{
    std::uint32_t pixel = 0;
    visit_components(type, [&](int i, int shift, std::uint32_t greatest) {
        // Which side a half falls on: libGLU multiplies these two types, 2_3_3_REV and 5_6_5_REV, in double.
        const double product = type.reversed && type.components == 3
                                   ? static_cast<double>(components[i]) * greatest
                                   : static_cast<double>(components[i] * static_cast<float>(greatest));
        pixel |= (static_cast<std::uint32_t>(product + 0.5) & greatest) << shift;
    });
    return pixel;
}

GLenum check_format_and_type(GLenum format, GLenum type)
{
    const bool has_alpha = format == GL_RGBA || format == GL_BGRA;
    if (components_of(format) == 0 || bytes_of(type) == 0) {
        return GLU_INVALID_ENUM;
    }
    if (const PackedType* packed = find_packed_type(type)) {
        if (packed->components == 3 ? format != GL_RGB : !has_alpha) {
            return GLU_INVALID_OPERATION;
        }
    }
    return 0;
}

int components_of(GLenum format)
{
    switch (format) {
    case GL_COLOR_INDEX:
    case GL_STENCIL_INDEX:
    case GL_DEPTH_COMPONENT:
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

int bytes_of(GLenum type)
{
    switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
        return 4;
    default: {
        const PackedType* packed = find_packed_type(type);
        return packed ? packed->bytes : 0;
    }
    }
}

} // namespace legacygl::glu
