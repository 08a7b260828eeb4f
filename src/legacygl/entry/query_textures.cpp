// Queries of textures: parameters, levels and texels (OpenGL 1.5, 6.1.3 and 6.1.4).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/query_convert.h"
#include "legacygl/pixel/pixel_conversion.h"
#include "legacygl/pixel/texture_image.h"
#include "legacygl/pixel/texture_targets.h"
#include "legacygl/state/internal_format.h"

using namespace legacygl;

namespace {

QueryValue parameter_value(TextureParameters& p, GLenum name)
{
    const auto real = [](GLfloat value) {
        return QueryValue(QueryValue::Kind::real, static_cast<double>(value));
    };
    switch (name) {
    case GL_TEXTURE_MIN_FILTER:
        return QueryValue::integer(p.sampling.minify);
    case GL_TEXTURE_MAG_FILTER:
        return QueryValue::integer(p.sampling.magnify);
    case GL_TEXTURE_WRAP_S:
        return QueryValue::integer(p.sampling.wrap_s);
    case GL_TEXTURE_WRAP_T:
        return QueryValue::integer(p.sampling.wrap_t);
    case GL_TEXTURE_WRAP_R:
        return QueryValue::integer(p.wrap_r);
    case GL_TEXTURE_BASE_LEVEL:
        return QueryValue::integer(p.sampling.base_level);
    case GL_TEXTURE_MAX_LEVEL:
        return QueryValue::integer(p.sampling.max_level);
    case GL_TEXTURE_MIN_LOD:
        return real(p.sampling.min_lod);
    case GL_TEXTURE_LOD_BIAS:
        return real(p.lod_bias);
    case GL_TEXTURE_MAX_LOD:
        return real(p.sampling.max_lod);
    case GL_TEXTURE_BORDER_COLOR:
        return QueryValue(StateField::fraction(p.border_color));
    case GL_TEXTURE_PRIORITY:
        return QueryValue(StateField::fraction(p.priority));
    case GL_TEXTURE_RESIDENT:
        return QueryValue::boolean(true);
    case GL_GENERATE_MIPMAP:
        return QueryValue::boolean(p.generate_mipmap);
    default:
        return {};
    }
}

/// Returns how many bits the level has of what is asked, luminance and intensity apart from red.
int component_bits(const TextureImage& image, GLenum name)
{
    if (image.width == 0) {
        return 0;
    }
    const std::array<int, 4> bits = texel_bits(image.internal_format);
    const BaseFormat base = base_format(image.internal_format);
    const bool luminance = base == BaseFormat::luminance || base == BaseFormat::luminance_alpha;
    const bool intensity = base == BaseFormat::intensity;
    switch (name) {
    case GL_TEXTURE_LUMINANCE_SIZE:
        return luminance ? bits[0] : 0;
    case GL_TEXTURE_INTENSITY_SIZE:
        return intensity ? bits[0] : 0;
    default: {
        const auto i = name - GL_TEXTURE_RED_SIZE;
        return i == 0 && (luminance || intensity) ? 0 : bits[i];
    }
    }
}

QueryValue level_value(const TextureImage& image, GLenum name)
{
    switch (name) {
    case GL_TEXTURE_WIDTH:
        return QueryValue::integer(image.width);
    case GL_TEXTURE_HEIGHT:
        return QueryValue::integer(image.height);
    case GL_TEXTURE_DEPTH:
        return QueryValue::integer(image.width > 0 ? 1 : 0);
    case GL_TEXTURE_INTERNAL_FORMAT:
        return QueryValue::integer(image.internal_format);
    case GL_TEXTURE_BORDER:
        return QueryValue::integer(0);
    case GL_TEXTURE_COMPRESSED:
        return QueryValue::boolean(false);
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE:
        return QueryValue::integer(component_bits(image, name));
    default:
        return {};
    }
}

const std::vector<TextureImage>& levels_of(Context& gl, const ImageTarget& target)
{
    return target.proxy ? gl.state.texturing.proxies[target.index]
                        : gl.state.texturing.bound(static_cast<TextureTarget>(target.index)).levels;
}

template <class T> void get_parameter(const char* entry, GLenum target, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum t, GLenum n) {
            const QueryValue value =
                is_texture_target(t) ? parameter_value(bound_texture(gl, t).parameters, n) : QueryValue{};
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        target, name);
}

template <class T>
void get_level_parameter(const char* entry, GLenum target, GLint level, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum t, GLint l, GLenum n) {
            std::optional<ImageTarget> found = find_image_target(t, 1);
            if (!found) {
                found = find_image_target(t, 2);
            }
            if (!found) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            if (!is_level(gl, l)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            const std::vector<TextureImage>& levels = levels_of(gl, *found);
            const bool there = static_cast<std::size_t>(l) < levels.size();
            const QueryValue value = level_value(there ? levels[l] : TextureImage{}, n);
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        target, level, name);
}

} // namespace

extern "C" {

void glGetTexParameterfv(GLenum target, GLenum pname, GLfloat* params)
{
    get_parameter(__func__, target, pname, params);
}

void glGetTexParameteriv(GLenum target, GLenum pname, GLint* params)
{
    get_parameter(__func__, target, pname, params);
}

void glGetTexLevelParameterfv(GLenum target, GLint level, GLenum pname, GLfloat* params)
{
    get_level_parameter(__func__, target, level, pname, params);
}

void glGetTexLevelParameteriv(GLenum target, GLint level, GLenum pname, GLint* params)
{
    get_level_parameter(__func__, target, level, pname, params);
}

void glGetTexImage(GLenum target, GLint level, GLenum format, GLenum type, GLvoid* pixels)
{
    dispatch_now(
        __func__,
        [pixels](Context& gl, GLenum t, GLint l, GLenum f, GLenum ty) {
            if (!is_texture_target(t)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            if (!is_level(gl, l)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            if (const GLenum error = format_type_error(f, ty); error != GL_NO_ERROR) {
                return gl.set_error(error);
            }
            const Texture& texture = bound_texture(gl, t);
            if (static_cast<std::size_t>(l) >= texture.levels.size()) {
                return;
            }
            const TextureImage& image = texture.levels[l];
            pack_pixels(gl.state.pack, image.width, image.height, f, ty, level_texels(texture, l),
                        ToLuminance::red, static_cast<std::uint8_t*>(pixels));
        },
        target, level, format, type);
}

} // extern "C"
