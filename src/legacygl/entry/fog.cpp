// Fog (OpenGL 1.5, 3.10).

#include "legacygl/context/dispatch.h"
#include "legacygl/vertex/component.h"

#include <algorithm>
#include <array>

using namespace legacygl;

namespace {

using Values = std::array<float, 4>;

void set_fog(Context& gl, GLenum name, const Values& v)
{
    FogState& fog = gl.state.fog;
    const auto value = static_cast<GLenum>(v[0]);
    gl.renderer.changed(change::fragments);
    switch (name) {
    case GL_FOG_MODE:
        if (value != GL_LINEAR && value != GL_EXP && value != GL_EXP2) {
            return gl.set_error(GL_INVALID_ENUM);
        }
        fog.mode = value;
        break;
    case GL_FOG_DENSITY:
        if (!(v[0] >= 0)) {
            return gl.set_error(GL_INVALID_VALUE);
        }
        fog.density = v[0];
        break;
    case GL_FOG_START:
        fog.start = v[0];
        break;
    case GL_FOG_END:
        fog.end = v[0];
        break;
    case GL_FOG_INDEX:
        fog.index = v[0];
        break;
    case GL_FOG_COLOR:
        for (int i = 0; i < 4; ++i) {
            fog.color[i] = std::clamp(v[i], 0.0f, 1.0f);
        }
        break;
    case GL_FOG_COORDINATE_SOURCE:
        if (value != GL_FOG_COORDINATE && value != GL_FRAGMENT_DEPTH) {
            return gl.set_error(GL_INVALID_ENUM);
        }
        fog.coordinate_source = value;
        break;
    default:
        gl.set_error(GL_INVALID_ENUM);
    }
}

template <class T> void fog(const char* entry, GLenum name, const T* params)
{
    Values values{};
    if (name == GL_FOG_COLOR) {
        std::transform(params, params + 4, values.begin(), [](T v) { return component(v); });
    } else {
        values[0] = static_cast<float>(params[0]);
    }
    dispatch(entry, set_fog, name, values);
}

/// The forms with one value are not for the colour.
template <class T> void fog_scalar(const char* entry, GLenum name, T value)
{
    fog(entry, name == GL_FOG_COLOR ? GLenum{GL_INVALID_ENUM} : name, &value);
}

} // namespace

extern "C" {

void glFogf(GLenum pname, GLfloat param)
{
    fog_scalar(__func__, pname, param);
}

void glFogi(GLenum pname, GLint param)
{
    fog_scalar(__func__, pname, param);
}

void glFogfv(GLenum pname, const GLfloat* params)
{
    fog(__func__, pname, params);
}

void glFogiv(GLenum pname, const GLint* params)
{
    fog(__func__, pname, params);
}

} // extern "C"
