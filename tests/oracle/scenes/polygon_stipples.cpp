// Polygon stipple (OpenGL 1.5, 3.5.2) and how its image is read.

#include "scenes/common.h"

#include <cstring>

using namespace oracle;

namespace {

/// The Red Book's halftone, and something without symmetry.
constexpr GLubyte HALFTONE_ROWS[8] = {0xaa, 0xaa, 0xaa, 0xaa, 0x55, 0x55, 0x55, 0x55};

void halftone(GLubyte* out)
{
    for (int i = 0; i < 128; ++i) {
        out[i] = HALFTONE_ROWS[i % 8];
    }
}

void arrow(GLubyte* out)
{
    for (int i = 0; i < 128; ++i) {
        out[i] = static_cast<GLubyte>(i % 4 == 0 ? 0xf0 >> (i / 16 % 4) : i * 37 + i / 4);
    }
}

} // namespace

/// As the Red Book's polys.c.
SCENE(red_book_polys)
{
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, WIDTH, 0, HEIGHT);
    glMatrixMode(GL_MODELVIEW);
    glShadeModel(GL_FLAT);
    GLubyte fly[128], half[128];
    arrow(fly);
    halftone(half);
    glColor3f(1, 1, 1);
    glRectf(5, 5, 50, 115);
    glEnable(GL_POLYGON_STIPPLE);
    glPolygonStipple(fly);
    glRectf(55, 5, 100, 115);
    glPolygonStipple(half);
    glRectf(105, 5, 155, 115);
    glDisable(GL_POLYGON_STIPPLE);
}

SCENE(polygon_stipple_leaves_lines_and_points_alone)
{
    three_dimensions();
    GLubyte pattern[128];
    arrow(pattern);
    glPolygonStipple(pattern);
    glEnable(GL_POLYGON_STIPPLE);
    glRotatef(30, 1, 1, 0);
    glTranslatef(-1, 0, 0);
    cube();
    glTranslatef(2, 0, 0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    cube();
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBegin(GL_LINES);
    glVertex3f(-3, -1.5f, 0);
    glVertex3f(1, -1.5f, 1);
    glEnd();
    glPointSize(9);
    glBegin(GL_POINTS);
    glVertex3f(0, 1.4f, 0);
    glEnd();
}

// Whole bytes are skipped: with 5 pixels, Mesa 22.3 writes a byte behind its own copy of the image. Bits are
// skipped in raster_test.cpp.
SCENE(polygon_stipple_reads_as_pixels_are_stored)
{
    two_dimensions();
    GLubyte image[40 * 8];
    for (int i = 0; i < 320; ++i) {
        image[i] = static_cast<GLubyte>(i * 29 + i / 8 * 5);
    }
    glEnable(GL_POLYGON_STIPPLE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 64);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 8);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPolygonStipple(image);
    glRectf(0.5f, 0.5f, 7.5f, 11.5f);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
    glPolygonStipple(image);
    glColor3f(1, 0.6f, 0.2f);
    glRectf(8.5f, 0.5f, 15.5f, 11.5f);
    GLubyte back[128];
    std::memset(back, 0, sizeof back);
    glGetPolygonStipple(back);
    unsigned sum = 0;
    for (int i = 0; i < 128; ++i) {
        sum = sum * 31 + back[i];
    }
    tell("stipple " + std::to_string(sum));
}

SCENE(polygon_stipple_compiled_into_a_list)
{
    two_dimensions();
    GLubyte pattern[128];
    arrow(pattern);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glPolygonStipple(pattern);
    glEnable(GL_POLYGON_STIPPLE);
    glRectf(2, 2, 14, 10);
    glEndList();
    std::memset(pattern, 0, sizeof pattern);
    glCallList(list);
}
