// Queries of texture environments and generated coordinates (OpenGL 1.5, 6.1.3).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/query_convert.h"

using namespace legacygl;

namespace {

QueryValue combine_value(const TextureUnit& unit, GLenum name)
{
    const auto one = [name](const std::array<GLenum, 3>& of, GLenum first) {
        return QueryValue::integer(of[name - first]);
    };
    switch (name) {
    case GL_COMBINE_RGB:
        return QueryValue::integer(unit.combine_rgb.function);
    case GL_COMBINE_ALPHA:
        return QueryValue::integer(unit.combine_alpha.function);
    case GL_RGB_SCALE:
        return {QueryValue::Kind::real, static_cast<double>(unit.combine_rgb.scale)};
    case GL_ALPHA_SCALE:
        return {QueryValue::Kind::real, static_cast<double>(unit.combine_alpha.scale)};
    case GL_SOURCE0_RGB:
    case GL_SOURCE1_RGB:
    case GL_SOURCE2_RGB:
        return one(unit.combine_rgb.sources, GL_SOURCE0_RGB);
    case GL_SOURCE0_ALPHA:
    case GL_SOURCE1_ALPHA:
    case GL_SOURCE2_ALPHA:
        return one(unit.combine_alpha.sources, GL_SOURCE0_ALPHA);
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
        return one(unit.combine_rgb.operands, GL_OPERAND0_RGB);
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
        return one(unit.combine_alpha.operands, GL_OPERAND0_ALPHA);
    default:
        return {};
    }
}

QueryValue environment_value(const TextureUnit& unit, GLenum target, GLenum name)
{
    if (target == GL_TEXTURE_FILTER_CONTROL && name == GL_TEXTURE_LOD_BIAS) {
        return {QueryValue::Kind::real, static_cast<double>(unit.lod_bias)};
    }
    if (target != GL_TEXTURE_ENV) {
        return {};
    }
    if (name == GL_TEXTURE_ENV_MODE) {
        return QueryValue::integer(unit.environment_mode);
    }
    if (name == GL_TEXTURE_ENV_COLOR) {
        glm::vec4 color = unit.environment_color;
        return QueryValue(StateField::fraction(color));
    }
    return combine_value(unit, name);
}

QueryValue generation_value(const TextureGeneration& generation, GLenum name)
{
    if (name == GL_TEXTURE_GEN_MODE) {
        return QueryValue::integer(generation.mode);
    }
    glm::vec4 plane = name == GL_OBJECT_PLANE ? generation.object_plane : generation.eye_plane;
    return name == GL_OBJECT_PLANE || name == GL_EYE_PLANE ? QueryValue(StateField(plane)) : QueryValue{};
}

template <class T> void get_environment(const char* entry, GLenum target, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum t, GLenum n) {
            const QueryValue value = environment_value(gl.state.texturing.unit(), t, n);
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        target, name);
}

template <class T> void get_generation(const char* entry, GLenum coordinate, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum c, GLenum n) {
            const bool is_coordinate = c >= GL_S && c <= GL_Q;
            const QueryValue value = is_coordinate
                                         ? generation_value(gl.state.texturing.unit().generation[c - GL_S], n)
                                         : QueryValue{};
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        coordinate, name);
}

} // namespace

extern "C" {

void glGetTexEnvfv(GLenum target, GLenum pname, GLfloat* params)
{
    get_environment(__func__, target, pname, params);
}

void glGetTexEnviv(GLenum target, GLenum pname, GLint* params)
{
    get_environment(__func__, target, pname, params);
}

void glGetTexGenfv(GLenum coord, GLenum pname, GLfloat* params)
{
    get_generation(__func__, coord, pname, params);
}

void glGetTexGendv(GLenum coord, GLenum pname, GLdouble* params)
{
    get_generation(__func__, coord, pname, params);
}

void glGetTexGeniv(GLenum coord, GLenum pname, GLint* params)
{
    get_generation(__func__, coord, pname, params);
}

} // extern "C"
