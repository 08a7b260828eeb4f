// Begin/End of the ten primitives, and attributes in every order (OpenGL 1.5, 2.6).

#include "scenes/common.h"

#include <cmath>

using namespace oracle;

namespace {

/// Gives vertices of a ring or a zigzag in cell (column, row) of a grid of 4 × 3 cells.
void vertices(int count, int column, int row, bool zigzag)
{
    for (int i = 0; i < count; ++i) {
        glColor3f(0.3f + 0.7f * static_cast<float>(i % 3 == 0), 0.3f + 0.7f * static_cast<float>(i % 3 == 1),
                  0.3f + 0.7f * static_cast<float>(i % 3 == 2));
        const double angle = 6.283185307179586 * i / count;
        const double x = zigzag ? 0.4 + 3.2 * (i / 2) / ((count - 1) / 2) : 2 + 1.7 * std::cos(angle);
        const double y = zigzag ? (i % 2 == 0 ? 0.4 : 3.5) : 2 + 1.7 * std::sin(angle);
        glVertex2d(4 * column + x, 4 * row + y);
    }
}

/// lines: how many vertices the separate lines get. In a list it must be even: Mesa 22.3 joins lines and a
/// strip that follow each other there, and an odd vertex shifts all that follow.
void all_primitives(int lines)
{
    struct
    {
        GLenum mode;
        int count;
        bool zigzag;
    } const cells[] = {{GL_POINTS, 7, false},       {GL_LINES, lines, false}, {GL_LINE_STRIP, 7, false},
                       {GL_LINE_LOOP, 7, false},    {GL_TRIANGLES, 7, false}, {GL_TRIANGLE_STRIP, 7, true},
                       {GL_TRIANGLE_FAN, 7, false}, {GL_POLYGON, 7, false},   {GL_QUAD_STRIP, 8, true},
                       {GL_TRIANGLE_STRIP, 6, true}};
    for (int i = 0; i < 10; ++i) {
        glBegin(cells[i].mode);
        vertices(cells[i].count, i % 4, i / 4, cells[i].zigzag);
        glEnd();
    }
}

} // namespace

SCENE(primitives_flat)
{
    two_dimensions();
    glShadeModel(GL_FLAT);
    all_primitives(7);
}

SCENE(primitives_from_a_list)
{
    two_dimensions();
    glShadeModel(GL_FLAT);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    all_primitives(6);
    glEndList();
    glCallList(list);
}

SCENE(primitives_smooth_triangles)
{
    two_dimensions();
    glBegin(GL_TRIANGLES);
    vertices(9, 1, 1, false);
    glEnd();
    glBegin(GL_TRIANGLE_STRIP);
    vertices(9, 0, 0, true);
    glEnd();
    glBegin(GL_TRIANGLE_FAN);
    vertices(9, 2, 0, false);
    glEnd();
}

SCENE(quads_of_one_colour)
{
    two_dimensions();
    glBegin(GL_QUADS);
    for (int i = 0; i < 5; ++i) {
        glColor3ub(static_cast<GLubyte>(40 * i), 200, static_cast<GLubyte>(255 - 40 * i));
        glVertex2i(3 * i, i);
        glVertex2i(3 * i + 2, i);
        glVertex2i(3 * i + 3, i + 6);
        glVertex2i(3 * i, i + 5);
    }
    glEnd();
}

SCENE(incomplete_primitives_draw_what_is_whole)
{
    two_dimensions();
    glShadeModel(GL_FLAT);
    const GLenum modes[] = {GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES,
                            GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
    for (int count = 0; count < 6; ++count) {
        for (int m = 0; m < 7; ++m) {
            glBegin(modes[m]);
            glColor3f(0.9f, 0.2f + 0.1f * static_cast<float>(m), 0.1f * static_cast<float>(count));
            for (int i = 0; i < count; ++i) {
                glVertex2d(2.3 * m + (i % 2 ? 1.6 : 0.2) + 0.1 * i, 2.0 * count + (i / 2 % 2 ? 1.6 : 0.2));
            }
            glEnd();
        }
    }
}

SCENE(attributes_set_in_the_middle)
{
    three_dimensions();
    glColor3f(1, 0, 0);
    glBegin(GL_TRIANGLES);
    glVertex3f(-2, -1, 0);
    glVertex3f(0, -1, 0);
    glColor4f(0, 1, 0, 0.5f);
    glVertex3f(-1, 1, 0);
    glColor3ub(0, 0, 255);
    glVertex4f(0, -2, 0, 2);
    glVertex2f(2, -1);
    glColor3f(1, 1, 0);
    glVertex3f(1, 1, -1);
    glEnd();
    glBegin(GL_TRIANGLES);
    glVertex3f(-1, 1, 0);
    glVertex3f(1, 1, 0);
    glVertex3f(0, 2, 0);
    glEnd();
}

SCENE(colours_of_every_type)
{
    two_dimensions();
    glShadeModel(GL_FLAT);
    int cell = 0;
    const auto triangle = [&cell] {
        const float x = static_cast<float>(cell % 4) * 4, y = static_cast<float>(cell / 4) * 3;
        glBegin(GL_TRIANGLES);
        glVertex2f(x, y);
        glVertex2f(x + 3.5f, y);
        glVertex2f(x, y + 2.5f);
        glEnd();
        ++cell;
    };
    glColor3b(127, 64, -1);
    triangle();
    glColor3s(32767, 1000, 12345);
    triangle();
    glColor3i(2147483647, 1000000000, 5);
    triangle();
    glColor3d(0.1, 0.5, 0.9);
    triangle();
    glColor3us(65535, 30000, 1);
    triangle();
    glColor3ui(4294967295u, 2000000000u, 7);
    triangle();
    const GLubyte bytes[4] = {10, 200, 77, 128};
    glColor4ubv(bytes);
    triangle();
    const GLfloat floats[3] = {1.5f, -0.5f, 0.25f};
    glColor3fv(floats);
    triangle();
}

SCENE(begin_inside_begin_is_an_error)
{
    two_dimensions();
    glBegin(GL_TRIANGLES);
    glVertex2f(1, 1);
    glBegin(GL_LINES);
    glVertex2f(10, 1);
    glMatrixMode(GL_PROJECTION);
    glEnable(GL_LIGHTING);
    glVertex2f(1, 10);
    glEnd();
    tell("error " + std::to_string(oracle::next_error()));
    glEnd();
    tell("error " + std::to_string(oracle::next_error()));
    glBegin(1234);
    tell("error " + std::to_string(oracle::next_error()));
}
