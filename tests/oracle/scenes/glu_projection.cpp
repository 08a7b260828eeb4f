// GLU's matrices, projections and strings (GLU 1.3, chapters 2, 4 and 8), told with every digit.

#include "scenes/common.h"

#include <cstdio>
#include <initializer_list>

using namespace oracle;

namespace {

/// Tells numbers so that no bit is lost.
void tell_numbers(const std::string& what, std::initializer_list<double> numbers)
{
    std::string line = what;
    for (const double number : numbers) {
        char text[40];
        std::snprintf(text, sizeof text, " %.17g", number);
        line += text;
    }
    tell(line);
}

void tell_matrix(const char* what, GLenum name)
{
    GLfloat m[16];
    glGetFloatv(name, m);
    for (int row = 0; row < 4; ++row) {
        tell_numbers(what, {static_cast<double>(m[row]), static_cast<double>(m[row + 4]),
                            static_cast<double>(m[row + 8]), static_cast<double>(m[row + 12])});
    }
}

void load_identity(GLenum mode)
{
    glMatrixMode(mode);
    glLoadIdentity();
}

/// Numbers that look random and are the same everywhere, given in the order they are asked for: so two of
/// them are never arguments of one call, but elements of one list, which has an order.
class Numbers
{
public:
    double operator()(double low, double high)
    {
        state_ = state_ * 1664525u + 1013904223u;
        return low + (high - low) * ((state_ >> 8) / 16777216.0);
    }

private:
    unsigned state_ = 12345;
};

} // namespace

SCENE(glu_matrices)
{
    load_identity(GL_PROJECTION);
    gluOrtho2D(-3, 5, 2.5, 11);
    tell_matrix("ortho2D", GL_PROJECTION_MATRIX);
    Numbers number;
    for (int i = 0; i < 20; ++i) {
        load_identity(GL_PROJECTION);
        const double view[] = {number(1, 179), number(0.2, 4), number(0.01, 2), number(3, 5000)};
        gluPerspective(view[0], view[1], view[2], view[3]);
        tell_matrix("perspective", GL_PROJECTION_MATRIX);
        load_identity(GL_MODELVIEW);
        const double look[] = {number(-9, 9), number(-9, 9), number(-9, 9), number(-9, 9), number(-9, 9),
                               number(-9, 9), number(-1, 1), number(-1, 1), number(-1, 1)};
        gluLookAt(look[0], look[1], look[2], look[3], look[4], look[5], look[6], look[7], look[8]);
        tell_matrix("lookAt", GL_MODELVIEW_MATRIX);
        GLint viewport[] = {10, 20, 300, 200};
        load_identity(GL_PROJECTION);
        const double pick[] = {number(0, 300), number(0, 200), number(1, 20), number(1, 20)};
        gluPickMatrix(pick[0], pick[1], pick[2], pick[3], viewport);
        tell_matrix("pick", GL_PROJECTION_MATRIX);
    }
    // Degenerate ones leave the matrix alone, or nearly.
    load_identity(GL_PROJECTION);
    GLint viewport[] = {0, 0, 100, 100};
    gluPerspective(45, 0, 1, 2);
    gluPerspective(0, 1, 1, 2);
    gluPerspective(45, 1, 2, 2);
    gluPickMatrix(5, 5, 0, 1, viewport);
    gluPickMatrix(5, 5, 1, -1, viewport);
    tell_matrix("degenerate", GL_PROJECTION_MATRIX);
    load_identity(GL_MODELVIEW);
    gluLookAt(1, 2, 3, 1, 2, 3, 0, 1, 0);
    tell_matrix("nowhere", GL_MODELVIEW_MATRIX);
    load_identity(GL_MODELVIEW);
    gluLookAt(0, 5, 0, 0, 0, 0, 0, 1, 0);
    tell_matrix("up along the view", GL_MODELVIEW_MATRIX);
}

SCENE(glu_project_and_unproject)
{
    Numbers number;
    const GLint viewport[] = {7, 11, 160, 120};
    for (int i = 0; i < 25; ++i) {
        GLdouble model[16], projection[16];
        if (i < 20) {
            load_identity(GL_MODELVIEW);
            const double look[] = {number(-9, 9), number(-9, 9), number(-9, 9),
                                   number(-2, 2), number(-2, 2), number(-2, 2)};
            gluLookAt(look[0], look[1], look[2], look[3], look[4], look[5], 0, 1, 0);
            load_identity(GL_PROJECTION);
            gluPerspective(number(20, 100), 1.5, 0.5, 100);
            glGetDoublev(GL_MODELVIEW_MATRIX, model);
            glGetDoublev(GL_PROJECTION_MATRIX, projection);
        } else {
            for (int k = 0; k < 16; ++k) {
                model[k] = number(-2, 2);
                projection[k] = i == 24 ? 0 : number(-2, 2); // The last has no inverse.
            }
        }
        double x = -1, y = -1, z = -1, w = -1;
        const double point[] = {number(-3, 3), number(-3, 3), number(-3, 3)};
        GLint good = gluProject(point[0], point[1], point[2], model, projection, viewport, &x, &y, &z);
        tell_numbers("project " + std::to_string(good), {x, y, z});
        const double window[] = {number(0, 160), number(0, 120), number(0, 1),
                                 number(0.5, 2), number(0, 0.4), number(0.6, 1)};
        good = gluUnProject(window[0], window[1], window[2], model, projection, viewport, &x, &y, &z);
        tell_numbers("unproject " + std::to_string(good), {x, y, z});
        good = gluUnProject4(window[0], window[1], window[2], window[3], model, projection, viewport,
                             window[4], window[5], &x, &y, &z, &w);
        tell_numbers("unproject4 " + std::to_string(good), {x, y, z, w});
    }
}

SCENE(glu_pick_matrix_magnifies)
{
    glClearColor(0.1f, 0.1f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    load_identity(GL_PROJECTION);
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    gluPickMatrix(100.5, 70.25, 40, 30, viewport);
    gluPerspective(45, static_cast<double>(WIDTH) / HEIGHT, 1, 20);
    load_identity(GL_MODELVIEW);
    gluLookAt(0, 1, 5, 0, 0, 0, 0, 1, 0);
    glShadeModel(GL_FLAT);
    for (int i = -5; i <= 5; ++i) {
        glColor3f(0.5f + 0.08f * static_cast<float>(i), 0.8f, 0.4f);
        glBegin(GL_TRIANGLES);
        glVertex3f(0.3f * static_cast<float>(i), 0, 0);
        glVertex3f(0.3f * static_cast<float>(i) + 0.25f, 0, 0.5f);
        glVertex3f(0.3f * static_cast<float>(i), 0.9f, -0.5f);
        glEnd();
    }
}

SCENE(glu_strings)
{
    for (const GLenum code :
         {GL_NO_ERROR, GL_INVALID_ENUM, GL_INVALID_VALUE, GL_INVALID_OPERATION, GL_STACK_OVERFLOW,
          GL_STACK_UNDERFLOW, GL_OUT_OF_MEMORY, GL_TABLE_TOO_LARGE, GLU_INVALID_ENUM, GLU_INVALID_VALUE,
          GLU_OUT_OF_MEMORY, GLU_INCOMPATIBLE_GL_VERSION, GLU_INVALID_OPERATION}) {
        tell(reinterpret_cast<const char*>(gluErrorString(static_cast<GLenum>(code))));
    }
    tell(gluErrorString(1) ? "text" : "none");
    tell(reinterpret_cast<const char*>(gluGetString(GLU_VERSION)));
    tell(gluGetString(GL_VERSION) ? "text" : "none");
    for (const char* name : {"GL_a", "GL_ab", "", "GL_a GL_b", "GL_c"}) {
        for (const char* list : {"GL_a GL_b", "GL_ab", "GL_ab GL_a ", "", "GL_b GL_c", "  GL_c"}) {
            tell(std::to_string(gluCheckExtension(reinterpret_cast<const GLubyte*>(name),
                                                  reinterpret_cast<const GLubyte*>(list))));
        }
    }
}
