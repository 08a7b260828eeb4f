// Quadric objects and their settings (GLU 1.3, 6.1 and 6.3).

#include "legacygl/glu/quadric.h"

#include <cmath>
#include <initializer_list>
#include <new>

namespace legacygl::glu {

AngleTable::AngleTable(int count, double span, double factor, double shift, float start)
{
    for (int i = 0; i <= count; ++i) {
        const auto in_float = static_cast<float>(static_cast<double>(start) + span * (i - shift) / count);
        const auto angle = static_cast<double>(in_float);
        sine[i] = static_cast<float>(factor * std::sin(angle));
        cosine[i] = static_cast<float>(factor * std::cos(angle));
    }
}

void AngleTable::close(int count)
{
    sine[count] = sine[0];
    cosine[count] = cosine[0];
}

AngleTable full_turn(int count, double factor, double shift)
{
    AngleTable table(count, 2 * PI, factor, shift);
    table.close(count);
    return table;
}

} // namespace legacygl::glu

namespace {

/// Changes a setting if the value is one of those allowed.
void set(const GLUquadric& quadric, GLenum& setting, GLenum value, std::initializer_list<GLenum> allowed)
{
    for (const GLenum one : allowed) {
        if (value == one) {
            setting = value;
            return;
        }
    }
    quadric.error(GLU_INVALID_ENUM);
}

} // namespace

GLUquadric* gluNewQuadric()
{
    return new (std::nothrow) GLUquadric;
}

void gluDeleteQuadric(GLUquadric* quad)
{
    delete quad;
}

void gluQuadricDrawStyle(GLUquadric* quad, GLenum draw)
{
    set(*quad, quad->draw_style, draw, {GLU_POINT, GLU_LINE, GLU_FILL, GLU_SILHOUETTE});
}

void gluQuadricNormals(GLUquadric* quad, GLenum normal)
{
    set(*quad, quad->normals, normal, {GLU_SMOOTH, GLU_FLAT, GLU_NONE});
}

void gluQuadricOrientation(GLUquadric* quad, GLenum orientation)
{
    set(*quad, quad->orientation, orientation, {GLU_OUTSIDE, GLU_INSIDE});
}

void gluQuadricTexture(GLUquadric* quad, GLboolean texture)
{
    quad->textured = texture != GL_FALSE;
}

void gluQuadricCallback(GLUquadric* quad, GLenum which, _GLUfuncptr CallBackFunc)
{
    if (which != GLU_ERROR) {
        return quad->error(GLU_INVALID_ENUM);
    }
    quad->error_callback = reinterpret_cast<void (*)(GLenum)>(CallBackFunc);
}
