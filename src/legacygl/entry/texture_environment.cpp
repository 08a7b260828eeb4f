// Texture units, environments and generated coordinates (OpenGL 1.5, 2.11.4 and 3.8.13).

#include "legacygl/context/dispatch.h"
#include "legacygl/vertex/component.h"

#include <algorithm>
#include <array>

using namespace legacygl;

namespace {

using Values = std::array<float, 4>;

bool is_environment_mode(GLenum mode)
{
    return mode == GL_MODULATE || mode == GL_DECAL || mode == GL_BLEND || mode == GL_REPLACE ||
           mode == GL_ADD || mode == GL_COMBINE;
}

bool is_combine_function(GLenum function, bool alpha)
{
    switch (function) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_ADD:
    case GL_ADD_SIGNED:
    case GL_INTERPOLATE:
    case GL_SUBTRACT:
        return true;
    case GL_DOT3_RGB:
    case GL_DOT3_RGBA:
        return !alpha;
    default:
        return false;
    }
}

bool is_combine_source(GLenum source)
{
    return source == GL_TEXTURE || source == GL_CONSTANT || source == GL_PRIMARY_COLOR ||
           source == GL_PREVIOUS || (source >= GL_TEXTURE0 && source < GL_TEXTURE0 + TEXTURE_UNIT_COUNT);
}

bool is_combine_operand(GLenum operand, bool alpha)
{
    if (operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA) {
        return true;
    }
    return !alpha && (operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR);
}

/// Sets one of the parameters of GL_COMBINE. Returns GL_NO_ERROR, or the error of a bad name or value.
GLenum set_combine(TextureUnit& unit, GLenum name, float v)
{
    const auto value = static_cast<GLenum>(v);
    const auto set = [value](GLenum& member, bool good) -> GLenum {
        if (!good) {
            return GL_INVALID_ENUM;
        }
        member = value;
        return GL_NO_ERROR;
    };
    const auto set_scale = [v](GLfloat& member) -> GLenum {
        if (v != 1 && v != 2 && v != 4) {
            return GL_INVALID_VALUE;
        }
        member = v;
        return GL_NO_ERROR;
    };
    switch (name) {
    case GL_COMBINE_RGB:
        return set(unit.combine_rgb.function, is_combine_function(value, false));
    case GL_COMBINE_ALPHA:
        return set(unit.combine_alpha.function, is_combine_function(value, true));
    case GL_RGB_SCALE:
        return set_scale(unit.combine_rgb.scale);
    case GL_ALPHA_SCALE:
        return set_scale(unit.combine_alpha.scale);
    case GL_SOURCE0_RGB:
    case GL_SOURCE1_RGB:
    case GL_SOURCE2_RGB:
        return set(unit.combine_rgb.sources[name - GL_SOURCE0_RGB], is_combine_source(value));
    case GL_SOURCE0_ALPHA:
    case GL_SOURCE1_ALPHA:
    case GL_SOURCE2_ALPHA:
        return set(unit.combine_alpha.sources[name - GL_SOURCE0_ALPHA], is_combine_source(value));
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
        return set(unit.combine_rgb.operands[name - GL_OPERAND0_RGB], is_combine_operand(value, false));
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
        return set(unit.combine_alpha.operands[name - GL_OPERAND0_ALPHA], is_combine_operand(value, true));
    default:
        return GL_INVALID_ENUM;
    }
}

void set_environment(Context& gl, GLenum target, GLenum name, const Values& v)
{
    TextureUnit& unit = gl.state.texturing.unit();
    gl.renderer.changed(change::texturing);
    if (target == GL_TEXTURE_FILTER_CONTROL && name == GL_TEXTURE_LOD_BIAS) {
        unit.lod_bias = v[0];
        return;
    }
    if (target != GL_TEXTURE_ENV) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    if (name == GL_TEXTURE_ENV_COLOR) {
        for (int i = 0; i < 4; ++i) {
            unit.environment_color[i] = std::clamp(v[i], 0.0f, 1.0f);
        }
    } else if (name == GL_TEXTURE_ENV_MODE) {
        if (!is_environment_mode(static_cast<GLenum>(v[0]))) {
            return gl.set_error(GL_INVALID_ENUM);
        }
        unit.environment_mode = static_cast<GLenum>(v[0]);
    } else if (const GLenum error = set_combine(unit, name, v[0]); error != GL_NO_ERROR) {
        gl.set_error(error);
    }
}

void set_generation(Context& gl, GLenum coordinate, GLenum name, const Values& v)
{
    if (coordinate < GL_S || coordinate > GL_Q) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    TextureGeneration& generation = gl.state.texturing.unit().generation[coordinate - GL_S];
    gl.renderer.changed(change::texturing);
    switch (name) {
    case GL_TEXTURE_GEN_MODE: {
        const auto mode = static_cast<GLenum>(v[0]);
        const bool sphere = mode == GL_SPHERE_MAP && (coordinate == GL_S || coordinate == GL_T);
        if (mode != GL_OBJECT_LINEAR && mode != GL_EYE_LINEAR && !sphere) {
            return gl.set_error(GL_INVALID_ENUM);
        }
        generation.mode = mode;
        break;
    }
    case GL_OBJECT_PLANE:
        generation.object_plane = {v[0], v[1], v[2], v[3]};
        break;
    case GL_EYE_PLANE: {
        // A plane is transformed by the inverse, as a row.
        const float* inverse = gl.state.transform.modelview.top().inverse();
        for (int column = 0; column < 4; ++column) {
            const float* m = inverse + 4 * column;
            generation.eye_plane[column] = v[0] * m[0] + v[1] * m[1] + v[2] * m[2] + v[3] * m[3];
        }
        break;
    }
    default:
        gl.set_error(GL_INVALID_ENUM);
    }
}

template <class T> void environment(const char* entry, GLenum target, GLenum name, const T* params)
{
    Values values{};
    if (name == GL_TEXTURE_ENV_COLOR) {
        std::transform(params, params + 4, values.begin(), [](T v) { return component(v); });
    } else {
        values[0] = static_cast<float>(params[0]);
    }
    dispatch(entry, set_environment, target, name, values);
}

template <class T> void generation(const char* entry, GLenum coordinate, GLenum name, const T* params)
{
    Values values{};
    const int count = name == GL_OBJECT_PLANE || name == GL_EYE_PLANE ? 4 : 1;
    std::transform(params, params + count, values.begin(), [](T v) { return static_cast<float>(v); });
    dispatch(entry, set_generation, coordinate, name, values);
}

/// The forms with one value are not for colours and planes.
template <class T> void environment_scalar(const char* entry, GLenum target, GLenum name, T value)
{
    environment(entry, target, name == GL_TEXTURE_ENV_COLOR ? GLenum{0} : name, &value);
}

template <class T> void generation_scalar(const char* entry, GLenum coordinate, GLenum name, T value)
{
    generation(entry, coordinate, name == GL_TEXTURE_GEN_MODE ? name : GLenum{0}, &value);
}

} // namespace

extern "C" {

void glActiveTexture(GLenum texture)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum t) {
            if (t < GL_TEXTURE0 || t >= GL_TEXTURE0 + TEXTURE_UNIT_COUNT) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.texturing.active = static_cast<int>(t - GL_TEXTURE0);
        },
        texture);
}

void glTexEnvf(GLenum target, GLenum pname, GLfloat param)
{
    environment_scalar(__func__, target, pname, param);
}

void glTexEnvi(GLenum target, GLenum pname, GLint param)
{
    environment_scalar(__func__, target, pname, param);
}

void glTexEnvfv(GLenum target, GLenum pname, const GLfloat* params)
{
    environment(__func__, target, pname, params);
}

void glTexEnviv(GLenum target, GLenum pname, const GLint* params)
{
    environment(__func__, target, pname, params);
}

void glTexGenf(GLenum coord, GLenum pname, GLfloat param)
{
    generation_scalar(__func__, coord, pname, param);
}

void glTexGend(GLenum coord, GLenum pname, GLdouble param)
{
    generation_scalar(__func__, coord, pname, param);
}

void glTexGeni(GLenum coord, GLenum pname, GLint param)
{
    generation_scalar(__func__, coord, pname, param);
}

void glTexGenfv(GLenum coord, GLenum pname, const GLfloat* params)
{
    generation(__func__, coord, pname, params);
}

void glTexGendv(GLenum coord, GLenum pname, const GLdouble* params)
{
    generation(__func__, coord, pname, params);
}

void glTexGeniv(GLenum coord, GLenum pname, const GLint* params)
{
    generation(__func__, coord, pname, params);
}

} // extern "C"
