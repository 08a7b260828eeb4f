// The part of GLU that is implemented so far: gluPerspective and gluLookAt (GLU 1.3, 4.1 and 4.2).

#include <GL/gl.h>
#include <GL/glu.h>

#include <cmath>

namespace {

constexpr double PI = 3.14159265358979323846;

void normalize(float v[3])
{
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (length == 0.0f)
        return;
    for (int i = 0; i < 3; ++i)
        v[i] /= length;
}

void cross(const float a[3], const float b[3], float out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

} // namespace

extern "C" {

void gluPerspective(GLdouble fovy, GLdouble aspect, GLdouble zNear, GLdouble zFar)
{
    const double half_angle = fovy / 2 * PI / 180;
    const double depth = zFar - zNear;
    const double sine = std::sin(half_angle);
    if (depth == 0 || sine == 0 || aspect == 0)
        return;
    const double cotangent = std::cos(half_angle) / sine;
    const GLdouble m[16] = {
        cotangent / aspect,        0, 0, 0, 0, cotangent, 0, 0, 0, 0, -(zFar + zNear) / depth, -1, 0, 0,
        -2 * zNear * zFar / depth, 0};
    glMultMatrixd(m);
}

void gluLookAt(GLdouble eyeX, GLdouble eyeY, GLdouble eyeZ, GLdouble centerX, GLdouble centerY,
               GLdouble centerZ, GLdouble upX, GLdouble upY, GLdouble upZ)
{
    float forward[3] = {static_cast<float>(centerX - eyeX), static_cast<float>(centerY - eyeY),
                        static_cast<float>(centerZ - eyeZ)};
    float up[3] = {static_cast<float>(upX), static_cast<float>(upY), static_cast<float>(upZ)};
    float side[3];
    normalize(forward);
    cross(forward, up, side);
    normalize(side);
    cross(side, forward, up);
    const GLfloat m[16] = {side[0], up[0], -forward[0], 0, side[1], up[1], -forward[1], 0,
                           side[2], up[2], -forward[2], 0, 0,       0,     0,           1};
    glMultMatrixf(m);
    glTranslated(-eyeX, -eyeY, -eyeZ);
}

} // extern "C"
