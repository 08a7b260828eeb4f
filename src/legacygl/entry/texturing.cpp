// Textures, their images and parameters (OpenGL 1.5, 3.8).

#include "legacygl/component.h"
#include "legacygl/dispatch.h"
#include "legacygl/pixel_conversion.h"

#include <algorithm>
#include <array>

using namespace legacygl;

namespace {

using Values = std::array<float, 4>;

bool is_target(GLenum target)
{
    return target == GL_TEXTURE_1D || target == GL_TEXTURE_2D;
}

/// target is one of is_target().
Texture& bound(Context& gl, GLenum target)
{
    return gl.state.texturing.bound(static_cast<TextureTarget>(target - GL_TEXTURE_1D));
}

void set_image(Context& gl, GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
               GLint border, GLenum format, GLenum type, const PixelStore& store, const Blob& pixels)
{
    const BaseFormat base = base_format(internal_format);
    if (base == BaseFormat::none || level < 0 || level > 11 || border < 0 || border > 1 || width < 0 ||
        height < 0 || width > MAXIMUM_TEXTURE_SIZE || height > MAXIMUM_TEXTURE_SIZE)
        return gl.set_error(GL_INVALID_VALUE);
    if (values_per_pixel(format) == 0 || bytes_per_value(type) == 0)
        return gl.set_error(GL_INVALID_ENUM);
    Texture& texture = bound(gl, target);
    if (texture.levels.size() <= static_cast<std::size_t>(level))
        texture.levels.resize(level + 1);
    TextureImage& image = texture.levels[level];
    image = {internal_format, width, height, border, {}};
    if (pixels.data)
        image.rgba = unpack_texture(store, width, height, format, type, base,
                                    static_cast<const std::uint8_t*>(pixels.data));
    else
        image.rgba.resize(static_cast<std::size_t>(width) * height * 4);
    texture.images_changed = true;
    gl.renderer.changed(Renderer::texturing);
}

bool is_minify_filter(GLenum filter)
{
    return filter == GL_NEAREST || filter == GL_LINEAR ||
           (filter >= GL_NEAREST_MIPMAP_NEAREST && filter <= GL_LINEAR_MIPMAP_LINEAR);
}

bool is_wrap_mode(GLenum mode)
{
    return mode == GL_CLAMP || mode == GL_REPEAT || mode == GL_CLAMP_TO_EDGE || mode == GL_MIRRORED_REPEAT;
}

void set_parameter(Context& gl, GLenum target, GLenum name, const Values& v)
{
    if (!is_target(target))
        return gl.set_error(GL_INVALID_ENUM);
    Texture& texture = bound(gl, target);
    const auto value = static_cast<GLenum>(v[0]);
    const auto set = [&](GLenum& member, bool good) {
        if (!good)
            return gl.set_error(GL_INVALID_ENUM);
        member = value;
        texture.sampling_changed = true;
    };
    gl.renderer.changed(Renderer::texturing);
    switch (name) {
    case GL_TEXTURE_MIN_FILTER:
        return set(texture.parameters.sampling.minify, is_minify_filter(value));
    case GL_TEXTURE_MAG_FILTER:
        return set(texture.parameters.sampling.magnify, value == GL_NEAREST || value == GL_LINEAR);
    case GL_TEXTURE_WRAP_S:
        return set(texture.parameters.sampling.wrap_s, is_wrap_mode(value));
    case GL_TEXTURE_WRAP_T:
        return set(texture.parameters.sampling.wrap_t, is_wrap_mode(value));
    case GL_TEXTURE_BORDER_COLOR:
        texture.parameters.border_color = {v[0], v[1], v[2], v[3]};
        return;
    case GL_GENERATE_MIPMAP:
        texture.parameters.generate_mipmap = v[0] != 0;
        return;
    default:
        gl.set_error(GL_INVALID_ENUM);
    }
}

template <class T> Values read(GLenum name, const T* params)
{
    const bool is_color = name == GL_TEXTURE_BORDER_COLOR;
    Values values{};
    for (int i = 0; i < (is_color ? 4 : 1); ++i)
        values[i] = is_color ? component(params[i]) : static_cast<float>(params[i]);
    return values;
}

template <class T> void parameter(const char* entry, GLenum target, GLenum name, const T* params)
{
    dispatch(entry, set_parameter, target, name, read(name, params));
}

} // namespace

extern "C" {

void glGenTextures(GLsizei n, GLuint* textures)
{
    dispatch_now(
        __func__,
        [textures](Context& gl, GLsizei count) {
            if (count < 0)
                return gl.set_error(GL_INVALID_VALUE);
            auto& all = gl.state.texturing.textures;
            GLuint name = 1;
            for (GLsizei i = 0; i < count; ++i, ++name) {
                while (all.contains(name))
                    ++name;
                all[name] = nullptr; // Reserved; a texture from its first binding on.
                textures[i] = name;
            }
        },
        n);
}

void glDeleteTextures(GLsizei n, const GLuint* textures)
{
    dispatch_now(
        __func__,
        [textures](Context& gl, GLsizei count) {
            if (count < 0)
                return gl.set_error(GL_INVALID_VALUE);
            TexturingState& state = gl.state.texturing;
            for (GLsizei i = 0; i < count; ++i) {
                if (textures[i] == 0)
                    continue;
                for (TextureUnit& unit : state.units)
                    for (GLuint& name : unit.bound)
                        if (name == textures[i])
                            name = 0;
                state.textures.erase(textures[i]);
            }
            gl.renderer.changed(Renderer::texturing);
        },
        n);
}

GLboolean glIsTexture(GLuint texture)
{
    bool is_texture = false;
    dispatch_now(
        __func__,
        [&is_texture](Context& gl, GLuint name) {
            const auto found = gl.state.texturing.textures.find(name);
            is_texture = name != 0 && found != gl.state.texturing.textures.end() && found->second;
        },
        texture);
    return is_texture;
}

void glBindTexture(GLenum target, GLuint texture)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLuint name) {
            if (!is_target(t))
                return gl.set_error(GL_INVALID_ENUM);
            if (name != 0) {
                std::shared_ptr<Texture>& object = gl.state.texturing.textures[name];
                if (!object) {
                    object = std::make_shared<Texture>();
                    object->target = t;
                }
                if (object->target != t)
                    return gl.set_error(GL_INVALID_OPERATION);
            }
            gl.state.texturing.unit().bound[t - GL_TEXTURE_1D] = name;
            gl.renderer.changed(Renderer::texturing);
        },
        target, texture);
}

void glTexImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const GLvoid* pixels)
{
    if (!current_context)
        return;
    const PixelStore store = current_context->state.unpack;
    const std::size_t size = pixels ? client_image_bytes(store, width, height, format, type) : 0;
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLint l, GLint internal, GLsizei w, GLsizei h, GLint b, GLenum f, GLenum ty,
           const PixelStore& s, const Blob& data) {
            if (t != GL_TEXTURE_2D)
                return gl.set_error(GL_INVALID_ENUM);
            set_image(gl, t, l, internal, w, h, b, f, ty, s, data);
        },
        target, level, internalFormat, width, height, border, format, type, store, Blob{pixels, size});
}

void glTexImage1D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLint border,
                  GLenum format, GLenum type, const GLvoid* pixels)
{
    if (!current_context)
        return;
    const PixelStore store = current_context->state.unpack;
    const std::size_t size = pixels ? client_image_bytes(store, width, 1, format, type) : 0;
    dispatch(
        __func__,
        [](Context& gl, GLenum t, GLint l, GLint internal, GLsizei w, GLint b, GLenum f, GLenum ty,
           const PixelStore& s, const Blob& data) {
            if (t != GL_TEXTURE_1D)
                return gl.set_error(GL_INVALID_ENUM);
            set_image(gl, t, l, internal, w, 1, b, f, ty, s, data);
        },
        target, level, internalFormat, width, border, format, type, store, Blob{pixels, size});
}

void glTexParameterf(GLenum target, GLenum pname, GLfloat param)
{
    parameter(__func__, target, pname, std::array<GLfloat, 4>{param}.data());
}

void glTexParameteri(GLenum target, GLenum pname, GLint param)
{
    parameter(__func__, target, pname, std::array<GLint, 4>{param}.data());
}

void glTexParameterfv(GLenum target, GLenum pname, const GLfloat* params)
{
    parameter(__func__, target, pname, params);
}

void glTexParameteriv(GLenum target, GLenum pname, const GLint* params)
{
    parameter(__func__, target, pname, params);
}

} // extern "C"
