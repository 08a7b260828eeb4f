// Queries of lights and materials (OpenGL 1.5, 6.1.3).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/query_convert.h"

using namespace legacygl;

namespace {

using Kind = QueryValue::Kind;

QueryValue values(Kind kind, const float* v, int count)
{
    QueryValue out;
    out.kind = kind;
    out.count = count;
    for (int i = 0; i < count; ++i) {
        out.values[i] = static_cast<double>(v[i]);
    }
    return out;
}

QueryValue color(const glm::vec4& v)
{
    return values(Kind::fraction, &v.x, 4);
}

QueryValue light_value(const Light& light, GLenum name)
{
    switch (name) {
    case GL_AMBIENT:
        return color(light.ambient);
    case GL_DIFFUSE:
        return color(light.diffuse);
    case GL_SPECULAR:
        return color(light.specular);
    case GL_POSITION:
        return values(Kind::real, &light.position.x, 4);
    case GL_SPOT_DIRECTION:
        return values(Kind::real, &light.spot_direction.x, 3);
    case GL_SPOT_EXPONENT:
        return values(Kind::real, &light.spot_exponent, 1);
    case GL_SPOT_CUTOFF:
        return values(Kind::real, &light.spot_cutoff_degrees, 1);
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
        return values(Kind::real, &light.attenuation[name - GL_CONSTANT_ATTENUATION], 1);
    default:
        return {};
    }
}

QueryValue material_value(const Material& material, GLenum name)
{
    switch (name) {
    case GL_AMBIENT:
        return color(material[MaterialProperty::ambient]);
    case GL_DIFFUSE:
        return color(material[MaterialProperty::diffuse]);
    case GL_SPECULAR:
        return color(material[MaterialProperty::specular]);
    case GL_EMISSION:
        return color(material[MaterialProperty::emission]);
    case GL_SHININESS:
        return values(Kind::real, &material.shininess, 1);
    case GL_COLOR_INDEXES: { // Never changed: a target has colours.
        constexpr float INITIAL[] = {0, 1, 1};
        return values(Kind::real, INITIAL, 3);
    }
    default:
        return {};
    }
}

template <class T> void get_light(const char* entry, GLenum light, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum l, GLenum n) {
            const bool is_light = l >= GL_LIGHT0 && l < GL_LIGHT0 + LIGHT_COUNT;
            const QueryValue value =
                is_light ? light_value(gl.state.lighting.lights[l - GL_LIGHT0], n) : QueryValue{};
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        light, name);
}

template <class T> void get_material(const char* entry, GLenum face, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum f, GLenum n) {
            gl.store_followed_color();
            const bool is_face = f == GL_FRONT || f == GL_BACK;
            const QueryValue value =
                is_face ? material_value(gl.state.lighting.materials[f == GL_BACK], n) : QueryValue{};
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        face, name);
}

} // namespace

extern "C" {

void glGetLightfv(GLenum light, GLenum pname, GLfloat* params)
{
    get_light(__func__, light, pname, params);
}

void glGetLightiv(GLenum light, GLenum pname, GLint* params)
{
    get_light(__func__, light, pname, params);
}

void glGetMaterialfv(GLenum face, GLenum pname, GLfloat* params)
{
    get_material(__func__, face, pname, params);
}

void glGetMaterialiv(GLenum face, GLenum pname, GLint* params)
{
    get_material(__func__, face, pname, params);
}

} // extern "C"
