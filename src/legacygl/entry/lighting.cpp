// Lights, materials and the shade model (OpenGL 1.5, 2.14).

#include "legacygl/context/dispatch.h"
#include "legacygl/vertex/component.h"

#include <array>

using namespace legacygl;

namespace {

using Values = std::array<float, 4>;

/// Returns how many values the parameter takes; 0: it is not one of a light, a material or a model.
int value_count(GLenum name)
{
    switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_POSITION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_LIGHT_MODEL_AMBIENT:
        return 4;
    case GL_SPOT_DIRECTION:
        return 3;
    case GL_SPOT_EXPONENT:
    case GL_SPOT_CUTOFF:
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
    case GL_SHININESS:
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
    case GL_LIGHT_MODEL_TWO_SIDE:
    case GL_LIGHT_MODEL_COLOR_CONTROL:
        return 1;
    default:
        return 0;
    }
}

bool is_color(GLenum name)
{
    return value_count(name) == 4 && name != GL_POSITION;
}

Values read(GLenum name, const GLfloat* params)
{
    Values values{};
    for (int i = 0; i < value_count(name); ++i) {
        values[i] = params[i];
    }
    return values;
}

Values read(GLenum name, const GLint* params)
{
    Values values{};
    for (int i = 0; i < value_count(name); ++i) {
        values[i] = is_color(name) ? component(params[i]) : static_cast<float>(params[i]);
    }
    return values;
}

glm::vec4 color(const Values& v)
{
    return {v[0], v[1], v[2], v[3]};
}

void set_light(Context& gl, GLenum which, GLenum name, const Values& v)
{
    if (which < GL_LIGHT0 || which >= GL_LIGHT0 + LIGHT_COUNT) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    Light& light = gl.state.lighting.lights[which - GL_LIGHT0];
    const Matrix& modelview = gl.state.transform.modelview.top();
    gl.renderer.changed(change::lighting);
    switch (name) {
    case GL_AMBIENT:
        light.ambient = color(v);
        break;
    case GL_DIFFUSE:
        light.diffuse = color(v);
        break;
    case GL_SPECULAR:
        light.specular = color(v);
        break;
    case GL_POSITION:
        light.position = modelview.transform(color(v));
        break;
    case GL_SPOT_DIRECTION: {
        const float* m = modelview.values();
        for (int row = 0; row < 3; ++row) {
            light.spot_direction[row] = v[0] * m[row] + v[1] * m[row + 4] + v[2] * m[row + 8];
        }
        break;
    }
    case GL_SPOT_EXPONENT:
        if (!(v[0] >= 0 && v[0] <= 128)) {
            return gl.set_error(GL_INVALID_VALUE);
        }
        light.spot_exponent = v[0];
        break;
    case GL_SPOT_CUTOFF:
        if (!((v[0] >= 0 && v[0] <= 90) || v[0] == 180)) {
            return gl.set_error(GL_INVALID_VALUE);
        }
        light.spot_cutoff_degrees = v[0];
        break;
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
        if (!(v[0] >= 0)) {
            return gl.set_error(GL_INVALID_VALUE);
        }
        light.attenuation[name - GL_CONSTANT_ATTENUATION] = v[0];
        break;
    default:
        gl.set_error(GL_INVALID_ENUM);
    }
}

void set_model(Context& gl, GLenum name, const Values& v)
{
    LightingState& lighting = gl.state.lighting;
    gl.renderer.changed(change::lighting);
    switch (name) {
    case GL_LIGHT_MODEL_AMBIENT:
        lighting.model_ambient = color(v);
        break;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
        lighting.local_viewer = v[0] != 0;
        break;
    case GL_LIGHT_MODEL_TWO_SIDE:
        lighting.two_side = v[0] != 0;
        break;
    case GL_LIGHT_MODEL_COLOR_CONTROL:
        if (v[0] == GL_SINGLE_COLOR) {
            lighting.separate_specular = false;
        } else if (v[0] == GL_SEPARATE_SPECULAR_COLOR) {
            lighting.separate_specular = true;
        } else {
            gl.set_error(GL_INVALID_ENUM);
        }
        break;
    default:
        gl.set_error(GL_INVALID_ENUM);
    }
}

void set_material(Context& gl, GLenum face, GLenum name, const Values& v)
{
    if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    if (name == GL_SHININESS && !(v[0] >= 0 && v[0] <= 128)) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    if (gl.immediate.inside()) {
        gl.immediate.change_material({0, face, name, v}, gl.state.lighting.materials);
    } else {
        gl.flush_vertices();
    }
    gl.renderer.changed(change::lighting);
    if (!gl.state.lighting.set_material(face, name, v)) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    gl.store_followed_color(); // What follows the colour is not changed by glMaterial.
}

template <class T> void light(const char* entry, GLenum which, GLenum name, const T* params)
{
    dispatch(entry, set_light, which, name, read(name, params));
}

template <class T> void material(const char* entry, GLenum face, GLenum name, const T* params)
{
    dispatch<Where::anywhere>(entry, set_material, face, name, read(name, params));
}

template <class T> void model(const char* entry, GLenum name, const T* params)
{
    dispatch(entry, set_model, name, read(name, params));
}

/// The forms with one value are only for parameters that have one.
template <class T, class Set> void scalar(const char* entry, GLenum name, T value, Set set)
{
    if (value_count(name) == 1) {
        set(&value);
    } else {
        dispatch(entry, [](Context& gl, GLenum) { gl.set_error(GL_INVALID_ENUM); }, name);
    }
}

} // namespace

extern "C" {

void glLightfv(GLenum which, GLenum pname, const GLfloat* params)
{
    light(__func__, which, pname, params);
}

void glLightiv(GLenum which, GLenum pname, const GLint* params)
{
    light(__func__, which, pname, params);
}

void glLightf(GLenum which, GLenum pname, GLfloat param)
{
    const char* entry = __func__;
    scalar(entry, pname, param, [=](const GLfloat* v) { light(entry, which, pname, v); });
}

void glLighti(GLenum which, GLenum pname, GLint param)
{
    const char* entry = __func__;
    scalar(entry, pname, param, [=](const GLint* v) { light(entry, which, pname, v); });
}

void glLightModelfv(GLenum pname, const GLfloat* params)
{
    model(__func__, pname, params);
}

void glLightModeliv(GLenum pname, const GLint* params)
{
    model(__func__, pname, params);
}

void glLightModelf(GLenum pname, GLfloat param)
{
    const char* entry = __func__;
    scalar(entry, pname, param, [=](const GLfloat* v) { model(entry, pname, v); });
}

void glLightModeli(GLenum pname, GLint param)
{
    const char* entry = __func__;
    scalar(entry, pname, param, [=](const GLint* v) { model(entry, pname, v); });
}

void glMaterialfv(GLenum face, GLenum pname, const GLfloat* params)
{
    material(__func__, face, pname, params);
}

void glMaterialiv(GLenum face, GLenum pname, const GLint* params)
{
    material(__func__, face, pname, params);
}

void glMaterialf(GLenum face, GLenum pname, GLfloat param)
{
    const char* entry = __func__;
    scalar(entry, pname, param, [=](const GLfloat* v) { material(entry, face, pname, v); });
}

void glMateriali(GLenum face, GLenum pname, GLint param)
{
    const char* entry = __func__;
    scalar(entry, pname, param, [=](const GLint* v) { material(entry, face, pname, v); });
}

void glColorMaterial(GLenum face, GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum f, GLenum m) {
            const bool face_is_good = f == GL_FRONT || f == GL_BACK || f == GL_FRONT_AND_BACK;
            const bool mode_is_good = m == GL_AMBIENT || m == GL_DIFFUSE || m == GL_SPECULAR ||
                                      m == GL_EMISSION || m == GL_AMBIENT_AND_DIFFUSE;
            if (!face_is_good || !mode_is_good) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.store_followed_color();
            gl.state.lighting.color_material_face = f;
            gl.state.lighting.color_material_mode = m;
            gl.store_followed_color();
            gl.renderer.changed(change::lighting);
        },
        face, mode);
}

void glShadeModel(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (m != GL_FLAT && m != GL_SMOOTH) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.lighting.shade_model = m;
            gl.renderer.changed(change::lighting);
        },
        mode);
}

} // extern "C"
