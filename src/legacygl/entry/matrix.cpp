// Matrices, the viewport and the depth range (OpenGL 1.5, 2.11).

#include "legacygl/context/dispatch.h"

#include <algorithm>
#include <array>

using namespace legacygl;

namespace {

using Values = std::array<float, 16>;

template <class T> Values floats(const T* m)
{
    Values out;
    std::transform(m, m + 16, out.begin(), [](T v) { return static_cast<float>(v); });
    return out;
}

void matrix_changed(Context& gl)
{
    gl.renderer.changed(gl.state.transform.matrix_mode == GL_TEXTURE ? change::texturing : change::matrices);
}

template <class T> Values transposed(const T* m)
{
    Values out;
    for (int i = 0; i < 16; ++i) {
        out[i] = static_cast<float>(m[i % 4 * 4 + i / 4]);
    }
    return out;
}

Matrix& top(Context& gl)
{
    matrix_changed(gl);
    return gl.current_matrix_stack().top();
}

void load(const char* name, const Values& values)
{
    dispatch(name, [](Context& gl, const Values& m) { top(gl).load(m.data()); }, values);
}

void multiply(const char* name, const Values& values)
{
    dispatch(name, [](Context& gl, const Values& m) { top(gl).multiply(m.data()); }, values);
}

void rotate(const char* name, float degrees, float x, float y, float z)
{
    dispatch(
        name, [](Context& gl, float d, float ax, float ay, float az) { top(gl).rotate(d, ax, ay, az); },
        degrees, x, y, z);
}

void scale(const char* name, float x, float y, float z)
{
    dispatch(name, [](Context& gl, float sx, float sy, float sz) { top(gl).scale(sx, sy, sz); }, x, y, z);
}

void translate(const char* name, float x, float y, float z)
{
    dispatch(name, [](Context& gl, float dx, float dy, float dz) { top(gl).translate(dx, dy, dz); }, x, y, z);
}

} // namespace

extern "C" {

void glMatrixMode(GLenum mode)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum m) {
            if (m != GL_MODELVIEW && m != GL_PROJECTION && m != GL_TEXTURE) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.transform.matrix_mode = m;
        },
        mode);
}

void glLoadIdentity()
{
    dispatch(__func__, [](Context& gl) { top(gl).set_identity(); });
}

void glLoadMatrixf(const GLfloat* m)
{
    load(__func__, floats(m));
}

void glLoadMatrixd(const GLdouble* m)
{
    load(__func__, floats(m));
}

void glMultMatrixf(const GLfloat* m)
{
    multiply(__func__, floats(m));
}

void glMultMatrixd(const GLdouble* m)
{
    multiply(__func__, floats(m));
}

void glLoadTransposeMatrixf(const GLfloat* m)
{
    load(__func__, transposed(m));
}

void glLoadTransposeMatrixd(const GLdouble* m)
{
    load(__func__, transposed(m));
}

void glMultTransposeMatrixf(const GLfloat* m)
{
    multiply(__func__, transposed(m));
}

void glMultTransposeMatrixd(const GLdouble* m)
{
    multiply(__func__, transposed(m));
}

void glRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z)
{
    rotate(__func__, angle, x, y, z);
}

void glRotated(GLdouble angle, GLdouble x, GLdouble y, GLdouble z)
{
    rotate(__func__, static_cast<float>(angle), static_cast<float>(x), static_cast<float>(y),
           static_cast<float>(z));
}

void glScalef(GLfloat x, GLfloat y, GLfloat z)
{
    scale(__func__, x, y, z);
}

void glScaled(GLdouble x, GLdouble y, GLdouble z)
{
    scale(__func__, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}

void glTranslatef(GLfloat x, GLfloat y, GLfloat z)
{
    translate(__func__, x, y, z);
}

void glTranslated(GLdouble x, GLdouble y, GLdouble z)
{
    translate(__func__, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}

void glFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top_, GLdouble zNear, GLdouble zFar)
{
    dispatch(
        __func__,
        [](Context& gl, double l, double r, double b, double t, double n, double f) {
            if (n <= 0 || f <= 0 || n == f || l == r || b == t) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            top(gl).frustum(static_cast<float>(l), static_cast<float>(r), static_cast<float>(b),
                            static_cast<float>(t), static_cast<float>(n), static_cast<float>(f));
        },
        left, right, bottom, top_, zNear, zFar);
}

void glOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top_, GLdouble zNear, GLdouble zFar)
{
    dispatch(
        __func__,
        [](Context& gl, double l, double r, double b, double t, double n, double f) {
            if (n == f || l == r || b == t) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            top(gl).ortho(static_cast<float>(l), static_cast<float>(r), static_cast<float>(b),
                          static_cast<float>(t), static_cast<float>(n), static_cast<float>(f));
        },
        left, right, bottom, top_, zNear, zFar);
}

void glPushMatrix()
{
    dispatch(__func__, [](Context& gl) {
        if (!gl.current_matrix_stack().push()) {
            gl.set_error(GL_STACK_OVERFLOW);
        }
    });
}

void glPopMatrix()
{
    dispatch(__func__, [](Context& gl) {
        if (!gl.current_matrix_stack().pop()) {
            return gl.set_error(GL_STACK_UNDERFLOW);
        }
        matrix_changed(gl);
    });
}

void glViewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
    dispatch(
        __func__,
        [](Context& gl, GLint vx, GLint vy, GLsizei w, GLsizei h) {
            if (w < 0 || h < 0) {
                return gl.set_error(GL_INVALID_VALUE);
            }
            const int greatest = gl.backend->maximum_viewport_size;
            gl.state.transform.viewport = {vx, vy, std::min(w, greatest), std::min(h, greatest)};
            gl.renderer.changed(change::pipeline | change::matrices); // Points are rounded within it.
        },
        x, y, width, height);
}

void glDepthRange(GLclampd zNear, GLclampd zFar)
{
    dispatch(
        __func__,
        [](Context& gl, double n, double f) {
            gl.state.transform.depth_range = {static_cast<float>(std::clamp(n, 0.0, 1.0)),
                                              static_cast<float>(std::clamp(f, 0.0, 1.0))};
            gl.renderer.changed(change::pipeline);
        },
        zNear, zFar);
}

} // extern "C"
