// Parameters of textures (OpenGL 1.5, 3.8.4).

#include "legacygl/context/dispatch.h"
#include "legacygl/pixel/texture_targets.h"
#include "legacygl/vertex/component.h"

#include <algorithm>
#include <array>

using namespace legacygl;

namespace {

using Values = std::array<float, 4>;

bool is_minify_filter(GLenum filter)
{
    return filter == GL_NEAREST || filter == GL_LINEAR ||
           (filter >= GL_NEAREST_MIPMAP_NEAREST && filter <= GL_LINEAR_MIPMAP_LINEAR);
}

bool is_wrap_mode(GLenum mode)
{
    return mode == GL_CLAMP || mode == GL_REPEAT || mode == GL_CLAMP_TO_EDGE || mode == GL_CLAMP_TO_BORDER ||
           mode == GL_MIRRORED_REPEAT;
}

/// Sets a parameter. Returns GL_NO_ERROR, or the error of a bad name or value.
GLenum set(TextureParameters& p, GLenum name, const Values& v)
{
    const auto choose = [&](GLenum& member, bool good) -> GLenum {
        if (good) {
            member = static_cast<GLenum>(v[0]);
        }
        return good ? GL_NO_ERROR : GL_INVALID_ENUM;
    };
    const auto set_level = [&](GLint& member) -> GLenum {
        if (!(v[0] >= 0)) {
            return GL_INVALID_VALUE;
        }
        member = static_cast<GLint>(v[0]);
        return GL_NO_ERROR;
    };
    const auto value = static_cast<GLenum>(std::max(v[0], 0.0f));
    switch (name) {
    case GL_TEXTURE_MIN_FILTER:
        return choose(p.sampling.minify, is_minify_filter(value));
    case GL_TEXTURE_MAG_FILTER:
        return choose(p.sampling.magnify, value == GL_NEAREST || value == GL_LINEAR);
    case GL_TEXTURE_WRAP_S:
        return choose(p.sampling.wrap_s, is_wrap_mode(value));
    case GL_TEXTURE_WRAP_T:
        return choose(p.sampling.wrap_t, is_wrap_mode(value));
    case GL_TEXTURE_WRAP_R:
        return choose(p.wrap_r, is_wrap_mode(value));
    case GL_TEXTURE_BASE_LEVEL:
        return set_level(p.sampling.base_level);
    case GL_TEXTURE_MAX_LEVEL:
        return set_level(p.sampling.max_level);
    case GL_TEXTURE_MIN_LOD:
        p.sampling.min_lod = v[0];
        return GL_NO_ERROR;
    case GL_TEXTURE_MAX_LOD:
        p.sampling.max_lod = v[0];
        return GL_NO_ERROR;
    case GL_TEXTURE_LOD_BIAS:
        p.lod_bias = v[0];
        return GL_NO_ERROR;
    case GL_TEXTURE_BORDER_COLOR:
        p.border_color = {v[0], v[1], v[2], v[3]};
        return GL_NO_ERROR;
    case GL_TEXTURE_PRIORITY:
        p.priority = std::clamp(v[0], 0.0f, 1.0f);
        return GL_NO_ERROR;
    case GL_GENERATE_MIPMAP:
        p.generate_mipmap = v[0] != 0;
        return GL_NO_ERROR;
    default:
        return GL_INVALID_ENUM;
    }
}

void set_parameter(Context& gl, GLenum target, GLenum name, const Values& v)
{
    if (!is_texture_target(target)) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    Texture& texture = bound_texture(gl, target);
    if (const GLenum error = set(texture.parameters, name, v); error != GL_NO_ERROR) {
        return gl.set_error(error);
    }
    texture.sampling_changed = true;
    gl.renderer.changed(change::texturing);
}

template <class T> void parameter(const char* entry, GLenum target, GLenum name, const T* params)
{
    Values values{};
    if (name == GL_TEXTURE_BORDER_COLOR) {
        std::transform(params, params + 4, values.begin(), [](T v) { return component(v); });
    } else {
        values[0] = name == GL_TEXTURE_PRIORITY ? component(params[0]) : static_cast<float>(params[0]);
    }
    dispatch(entry, set_parameter, target, name, values);
}

/// The forms with one value are not for the colour.
template <class T> void scalar(const char* entry, GLenum target, GLenum name, T value)
{
    parameter(entry, target, name == GL_TEXTURE_BORDER_COLOR ? GLenum{0} : name, &value);
}

} // namespace

extern "C" {

void glTexParameterf(GLenum target, GLenum pname, GLfloat param)
{
    scalar(__func__, target, pname, param);
}

void glTexParameteri(GLenum target, GLenum pname, GLint param)
{
    scalar(__func__, target, pname, param);
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
