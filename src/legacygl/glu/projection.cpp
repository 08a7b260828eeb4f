// Matrices (GLU 1.3, chapter 4.1): each multiplies the current matrix, so that lists hold it.
//
// Doubles and floats stand where the common libGLU has them: pictures are compared with its to the byte.

#include <GL/gl.h>
#include <GL/glu.h>

#include <array>
#include <cmath>

namespace {

constexpr double PI = 3.14159265358979323846;

using Vector = std::array<float, 3>;

Vector normalized(Vector v)
{
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (length != 0.0f) {
        for (float& component : v) {
            component /= length;
        }
    }
    return v;
}

Vector cross(const Vector& a, const Vector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace

void gluOrtho2D(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top)
{
    glOrtho(left, right, bottom, top, -1, 1);
}

void gluPerspective(GLdouble fovy, GLdouble aspect, GLdouble zNear, GLdouble zFar)
{
    const double half_angle = fovy / 2 * PI / 180;
    const double depth = zFar - zNear;
    const double sine = std::sin(half_angle);
    if (depth == 0 || sine == 0 || aspect == 0) {
        return;
    }
    const double cotangent = std::cos(half_angle) / sine;
    const GLdouble m[16] = {
        cotangent / aspect,        0, 0, 0, 0, cotangent, 0, 0, 0, 0, -(zFar + zNear) / depth, -1, 0, 0,
        -2 * zNear * zFar / depth, 0};
    glMultMatrixd(m);
}

void gluLookAt(GLdouble eyeX, GLdouble eyeY, GLdouble eyeZ, GLdouble centerX, GLdouble centerY,
               GLdouble centerZ, GLdouble upX, GLdouble upY, GLdouble upZ)
{
    const Vector forward = normalized({static_cast<float>(centerX - eyeX), static_cast<float>(centerY - eyeY),
                                       static_cast<float>(centerZ - eyeZ)});
    const Vector side = normalized(
        cross(forward, {static_cast<float>(upX), static_cast<float>(upY), static_cast<float>(upZ)}));
    const Vector up = cross(side, forward);
    const GLfloat m[16] = {side[0], up[0], -forward[0], 0, side[1], up[1], -forward[1], 0,
                           side[2], up[2], -forward[2], 0, 0,       0,     0,           1};
    glMultMatrixf(m);
    glTranslated(-eyeX, -eyeY, -eyeZ);
}

void gluPickMatrix(GLdouble x, GLdouble y, GLdouble delX, GLdouble delY, GLint* viewport)
{
    if (delX <= 0 || delY <= 0) {
        return;
    }
    glTranslatef(static_cast<float>((viewport[2] - 2 * (x - viewport[0])) / delX),
                 static_cast<float>((viewport[3] - 2 * (y - viewport[1])) / delY), 0);
    glScalef(static_cast<float>(viewport[2] / delX), static_cast<float>(viewport[3] / delY), 1);
}
