// glRect (OpenGL 1.5, 2.10). The specification has a polygon; Mesa draws a quad, which is seen in the order of
// a stippled outline, in the diagonal, and where a light at a place and flat shading make corners differ.

#include <GL/gl.h>

namespace {

void rectangle(double x1, double y1, double x2, double y2)
{
    glBegin(GL_QUADS);
    glVertex2d(x1, y1);
    glVertex2d(x2, y1);
    glVertex2d(x2, y2);
    glVertex2d(x1, y2);
    glEnd();
}

} // namespace

extern "C" {

#define RECT(suffix, type)                                                                                   \
    void glRect##suffix(type x1, type y1, type x2, type y2)                                                  \
    {                                                                                                        \
        rectangle(static_cast<double>(x1), static_cast<double>(y1), static_cast<double>(x2),                 \
                  static_cast<double>(y2));                                                                  \
    }                                                                                                        \
    void glRect##suffix##v(const type* v1, const type* v2)                                                   \
    {                                                                                                        \
        glRect##suffix(v1[0], v1[1], v2[0], v2[1]);                                                          \
    }
RECT(s, GLshort)
RECT(i, GLint)
RECT(f, GLfloat)
RECT(d, GLdouble)
#undef RECT

} // extern "C"
