// How points, lines and polygons are rasterised (OpenGL 1.5, 3.3 to 3.5).

#define GL_GLEXT_PROTOTYPES
#include "legacygl/context/dispatch.h"
#include "legacygl/pixel/stipple_image.h"

#include <algorithm>

using namespace legacygl;

namespace {

bool is_face(GLenum face)
{
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
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

void glCullFace(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (!is_face(m)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.raster.cull_face_mode = m;
            gl.renderer.changed(change::pipeline);
        },
        mode);
}

void glFrontFace(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (m != GL_CW && m != GL_CCW) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.raster.front_face = m;
            gl.renderer.changed(change::pipeline);
        },
        mode);
}

void glLineWidth(GLfloat width)
{
    dispatch(
        __func__,
        [](Context& gl, float w) {
            if (!(w > 0)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.state.raster.line_width = w;
            gl.renderer.changed(change::pipeline);
        },
        width);
}

void glPointSize(GLfloat size)
{
    dispatch(
        __func__,
        [](Context& gl, float s) {
            if (!(s > 0)) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            gl.state.raster.point_size = s;
            gl.renderer.changed(change::matrices); // It lies beside the matrices.
        },
        size);
}

void glPolygonOffset(GLfloat factor, GLfloat units)
{
    dispatch(
        __func__,
        [](Context& gl, float f, float u) {
            gl.state.raster.polygon_offset_factor = f;
            gl.state.raster.polygon_offset_units = u;
            gl.renderer.changed(change::pipeline);
        },
        factor, units);
}

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

} // extern "C"
