// Queries (OpenGL 1.5, 6.1).

#include "legacygl/context/dispatch.h"
#include "legacygl/context/query_convert.h"

using namespace legacygl;

namespace {

/// Extensions that are wholly there, with their own names too, in the order of the alphabet.
constexpr const char* EXTENSIONS =
    "GL_ATI_blend_equation_separate GL_ARB_multitexture GL_ARB_texture_border_clamp GL_ARB_texture_env_add "
    "GL_ARB_texture_env_combine "
    "GL_ARB_texture_env_crossbar GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat "
    "GL_ARB_texture_non_power_of_two GL_ARB_transpose_matrix GL_ARB_vertex_buffer_object GL_EXT_bgra "
    "GL_EXT_blend_color GL_EXT_blend_equation_separate GL_EXT_blend_func_separate GL_EXT_blend_minmax "
    "GL_EXT_blend_subtract "
    "GL_EXT_copy_texture GL_EXT_draw_range_elements GL_EXT_fog_coord GL_EXT_multi_draw_arrays "
    "GL_EXT_packed_pixels GL_EXT_polygon_offset GL_EXT_rescale_normal GL_EXT_secondary_color "
    "GL_EXT_separate_specular_color GL_EXT_stencil_wrap GL_EXT_subtexture GL_EXT_texture "
    "GL_EXT_texture_env_add "
    "GL_EXT_texture_lod_bias GL_EXT_texture_object GL_EXT_vertex_array GL_SGIS_generate_mipmap "
    "GL_SGIS_texture_border_clamp "
    "GL_SGIS_texture_edge_clamp GL_SGIS_texture_lod";

template <class T> void get(const char* entry, GLenum name, T* params)
{
    dispatch_now(
        entry,
        [params](Context& gl, GLenum n) {
            const QueryValue value = query(gl, n);
            if (value.count == 0) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            write_values(value, params);
        },
        name);
}

} // namespace

extern "C" {

void glGetBooleanv(GLenum pname, GLboolean* params)
{
    get(__func__, pname, params);
}

void glGetIntegerv(GLenum pname, GLint* params)
{
    get(__func__, pname, params);
}

void glGetFloatv(GLenum pname, GLfloat* params)
{
    get(__func__, pname, params);
}

void glGetDoublev(GLenum pname, GLdouble* params)
{
    get(__func__, pname, params);
}

GLenum glGetError()
{
    GLenum code = GL_NO_ERROR;
    dispatch_now(__func__, [&code](Context& gl) { code = std::exchange(gl.error, GL_NO_ERROR); });
    return code;
}

const GLubyte* glGetString(GLenum name)
{
    const char* text = nullptr;
    dispatch_now(
        __func__,
        [&text](Context& gl, GLenum n) {
            switch (n) {
            case GL_VENDOR:
                text = "Tank Lab";
                break;
            case GL_RENDERER:
                text = "legacygl";
                break;
            case GL_VERSION:
                text = "1.0 legacygl (a part of OpenGL 1.1; see legacygl.h)";
                break;
            case GL_EXTENSIONS:
                text = EXTENSIONS;
                break;
            default:
                gl.set_error(GL_INVALID_ENUM);
            }
        },
        name);
    return reinterpret_cast<const GLubyte*>(text);
}

} // extern "C"
