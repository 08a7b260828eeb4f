// How points, lines and polygons are rasterised (OpenGL 1.5, 3.3 to 3.5), and user clip planes (2.12).

#define GL_GLEXT_PROTOTYPES
#include "legacygl/context/dispatch.h"
#include "legacygl/pixel/stipple_image.h"

#include <algorithm>

using namespace legacygl;

namespace {

using Equation = std::array<double, 4>;

/// Planes are transformed by the inverse of what points are transformed by, as rows.
glm::vec4 plane_in_eye_space(const Equation& plane, const float* inverse)
{
    glm::vec4 out;
    for (int column = 0; column < 4; ++column) {
        const float* m = inverse + 4 * column;
        out[column] = static_cast<float>(plane[0]) * m[0] + static_cast<float>(plane[1]) * m[1] +
                      static_cast<float>(plane[2]) * m[2] + static_cast<float>(plane[3]) * m[3];
    }
    return out;
}

bool is_clip_plane(GLenum name)
{
    return name >= GL_CLIP_PLANE0 && name < GL_CLIP_PLANE0 + CLIP_PLANE_COUNT;
}

void set_point_parameter(Context& gl, GLenum name, const std::array<float, 3>& v)
{
    PointParameters& parameters = gl.state.raster.point_parameters;
    gl.renderer.changed(change::matrices);
    if (name == GL_POINT_DISTANCE_ATTENUATION) {
        parameters.attenuation = v;
        return;
    }
    if (name != GL_POINT_SIZE_MIN && name != GL_POINT_SIZE_MAX && name != GL_POINT_FADE_THRESHOLD_SIZE) {
        return gl.set_error(GL_INVALID_ENUM);
    }
    if (!(v[0] >= 0)) {
        return gl.set_error(GL_INVALID_VALUE);
    }
    (name == GL_POINT_SIZE_MIN   ? parameters.minimum
     : name == GL_POINT_SIZE_MAX ? parameters.maximum
                                 : parameters.fade_threshold) = v[0];
}

template <class T> void point_parameter(const char* entry, GLenum name, const T* v)
{
    std::array<float, 3> values{static_cast<float>(v[0]), 0, 0};
    if (name == GL_POINT_DISTANCE_ATTENUATION) {
        values = {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    }
    dispatch(entry, set_point_parameter, name, values);
}

/// The forms with one value are only for parameters that have one.
template <class T> void one_point_parameter(const char* entry, GLenum name, T value)
{
    if (name != GL_POINT_DISTANCE_ATTENUATION) {
        return point_parameter(entry, name, &value);
    }
    dispatch(entry, [](Context& gl, GLenum) { gl.set_error(GL_INVALID_ENUM); }, name);
}

void set_provoking_vertex(const char* entry, GLenum mode)
{
    dispatch(
        entry,
        [](Context& gl, GLenum m) {
            if (m != GL_FIRST_VERTEX_CONVENTION && m != GL_LAST_VERTEX_CONVENTION) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.raster.provoking_vertex = m;
        },
        mode);
}

} // namespace

extern "C" {

void glPolygonMode(GLenum face, GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum f, GLenum m) {
            const bool face_is_good = f == GL_FRONT || f == GL_BACK || f == GL_FRONT_AND_BACK;
            if (!face_is_good || (m != GL_POINT && m != GL_LINE && m != GL_FILL)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            for (int side = 0; side < 2; ++side) {
                if (f != (side == 0 ? GL_BACK : GL_FRONT)) {
                    gl.state.raster.polygon_mode[side] = m;
                }
            }
        },
        face, mode);
}

void glLineStipple(GLint factor, GLushort pattern)
{
    dispatch(
        __func__,
        [](Context& gl, GLint f, GLushort p) {
            gl.state.raster.line_stipple.factor = std::clamp(f, 1, 256);
            gl.state.raster.line_stipple.pattern = p;
        },
        factor, pattern);
}

void glPolygonStipple(const GLubyte* mask)
{
    if (!current_context) {
        return;
    }
    dispatch(
        __func__,
        [](Context& gl, const StippleRows& rows) {
            gl.state.raster.polygon_stipple.rows = rows;
            gl.renderer.changed(change::fragments);
        },
        unpack_stipple(current_context->state.unpack, mask));
}

void glGetPolygonStipple(GLubyte* mask)
{
    dispatch_now(__func__, [mask](Context& gl) {
        pack_stipple(gl.state.raster.polygon_stipple.rows, gl.state.pack, mask);
    });
}

void glPointParameterf(GLenum pname, GLfloat param)
{
    one_point_parameter(__func__, pname, param);
}

void glPointParameteri(GLenum pname, GLint param)
{
    one_point_parameter(__func__, pname, param);
}

void glPointParameterfv(GLenum pname, const GLfloat* params)
{
    point_parameter(__func__, pname, params);
}

void glPointParameteriv(GLenum pname, const GLint* params)
{
    point_parameter(__func__, pname, params);
}

void glPointParameterfARB(GLenum pname, GLfloat param)
{
    one_point_parameter(__func__, pname, param);
}

void glPointParameterfvARB(GLenum pname, const GLfloat* params)
{
    point_parameter(__func__, pname, params);
}

void glPointParameterfEXT(GLenum pname, GLfloat param)
{
    one_point_parameter(__func__, pname, param);
}

void glPointParameterfvEXT(GLenum pname, const GLfloat* params)
{
    point_parameter(__func__, pname, params);
}

void glProvokingVertex(GLenum mode)
{
    set_provoking_vertex(__func__, mode);
}

void glProvokingVertexEXT(GLenum mode)
{
    set_provoking_vertex(__func__, mode);
}

void glClipPlane(GLenum plane, const GLdouble* equation)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum p, const Equation& e) {
            if (!is_clip_plane(p)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.transform.clip_planes[p - GL_CLIP_PLANE0].equation =
                plane_in_eye_space(e, gl.state.transform.modelview.top().inverse());
        },
        plane, Equation{equation[0], equation[1], equation[2], equation[3]});
}

void glGetClipPlane(GLenum plane, GLdouble* equation)
{
    dispatch_now(
        __func__,
        [equation](Context& gl, GLenum p) {
            if (!is_clip_plane(p)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            for (int i = 0; i < 4; ++i) {
                equation[i] =
                    static_cast<double>(gl.state.transform.clip_planes[p - GL_CLIP_PLANE0].equation[i]);
            }
        },
        plane);
}

void glLogicOp(GLenum opcode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum op) {
            if (op < GL_CLEAR || op > GL_SET) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.fragment.logic_op = op;
            gl.renderer.changed(change::pipeline);
        },
        opcode);
}

} // extern "C"
