// glReadPixels of depth and stencil, which ES cannot read itself.

#define GL_GLEXT_PROTOTYPES
#include "scenes/common.h"

#include <algorithm>
#include <string>
#include <vector>

namespace {

using oracle::tell;

/// Draws a tilted square, a nearer one and a stencil of what overlaps.
void depths_and_stencils()
{
    oracle::two_dimensions();
    glClearStencil(5);
    glClear(GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 200, 255);
    glStencilOp(GL_KEEP, GL_INCR, GL_REPLACE);
    glColor3f(1, 0.5f, 0);
    glBegin(GL_QUADS);
    glVertex3f(1, 1, -0.9f);
    glVertex3f(14, 2, 0.8f);
    glVertex3f(13, 10, 0.9f);
    glVertex3f(2, 11, -0.7f);
    glEnd();
    glStencilOp(GL_KEEP, GL_INCR, GL_INVERT);
    glColor3f(0, 0.5f, 1);
    glBegin(GL_QUADS);
    glVertex3f(5, 3, 0.1f);
    glVertex3f(15, 3, 0.1f);
    glVertex3f(15, 8, 0.1f);
    glVertex3f(5, 8, 0.1f);
    glEnd();
}

template <class T> void tell_read(const char* what, GLenum format, GLenum type)
{
    std::vector<T> values(std::size_t{16} * 12);
    for (int y = 0; y < 12; ++y) { // A pixel of each field of the drawing.
        for (int x = 0; x < 16; ++x) {
            glReadPixels(10 * x + 5, 10 * y + 5, 1, 1, format, type, &values[16 * y + x]);
        }
    }
    for (int y = 0; y < 12; ++y) {
        std::string line = what;
        for (int x = 0; x < 16; ++x) {
            line += " " + std::to_string(values[16 * y + x]);
        }
        tell(line);
    }
}

SCENE(depths_are_read_in_every_type)
{
    depths_and_stencils();
    tell_read<GLuint>("unsigned int", GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    tell_read<GLfloat>("float", GL_DEPTH_COMPONENT, GL_FLOAT);
    tell_read<GLushort>("unsigned short", GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT);
    tell_read<GLubyte>("unsigned byte", GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE);
    tell_read<GLint>("int", GL_DEPTH_COMPONENT, GL_INT);
    tell_read<GLshort>("short", GL_DEPTH_COMPONENT, GL_SHORT);
    tell_read<GLbyte>("byte", GL_DEPTH_COMPONENT, GL_BYTE);
}

SCENE(stencils_are_read_in_every_type)
{
    depths_and_stencils();
    tell_read<GLuint>("unsigned int", GL_STENCIL_INDEX, GL_UNSIGNED_INT);
    tell_read<GLfloat>("float", GL_STENCIL_INDEX, GL_FLOAT);
    tell_read<GLushort>("unsigned short", GL_STENCIL_INDEX, GL_UNSIGNED_SHORT);
    tell_read<GLubyte>("unsigned byte", GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
    tell_read<GLshort>("short", GL_STENCIL_INDEX, GL_SHORT);
}

SCENE(depths_are_packed_as_pixels_are_stored)
{
    depths_and_stencils();
    std::vector<GLushort> values(std::size_t{20} * 14, GLushort{7});
    glPixelStorei(GL_PACK_ROW_LENGTH, 20);
    glPixelStorei(GL_PACK_SKIP_ROWS, 2);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 2);
    glReadPixels(-2, -1, 16, 12, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, values.data());
    for (int y = 0; y < 14; ++y) {
        std::string line = "row";
        for (int x = 0; x < 20; ++x) {
            line += " " + std::to_string(values[20 * y + x]);
        }
        tell(line);
    }
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_SKIP_ROWS, 0);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
}

SCENE(drawing_goes_on_after_depths_were_read)
{
    oracle::two_dimensions();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3f(0.5f, 0.2f, 0.1f);
    for (int i = 0; i < 5; ++i) {
        glRectf(1 + 2.0f * static_cast<float>(i), 1, 5 + 2.0f * static_cast<float>(i), 11);
        GLfloat depth = 0;
        glReadPixels(40, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        tell(std::to_string(depth));
        glTranslatef(0, 0, 0.1f);
    }
}

SCENE(unproject_what_the_depth_says_is_under_the_pointer)
{
    oracle::three_dimensions();
    glRotatef(30, 1, 1, 0);
    oracle::cube();
    GLdouble modelview[16], projection[16];
    GLint viewport[4];
    glGetDoublev(GL_MODELVIEW_MATRIX, modelview);
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetIntegerv(GL_VIEWPORT, viewport);
    for (int x = 50; x < 110; x += 20) {
        GLfloat depth = 0;
        GLdouble at[3];
        glReadPixels(x, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        gluUnProject(x, 60, static_cast<double>(depth), modelview, projection, viewport, &at[0], &at[1],
                     &at[2]);
        tell(std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]));
    }
}

SCENE(blend_equations_of_colours_and_alpha)
{
    glClearColor(0.3f, 0.4f, 0.5f, 0.6f);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    constexpr GLenum EQUATIONS[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 5, 0, 5, -1, 1);
    glColor4f(0.8f, 0.2f, 0.6f, 0.5f);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) {
            glBlendEquationSeparate(EQUATIONS[x], EQUATIONS[y]);
            glRectf(static_cast<float>(x) + 0.1f, static_cast<float>(y) + 0.1f, static_cast<float>(x) + 0.9f,
                    static_cast<float>(y) + 0.9f);
        }
    }
    GLint rgb = 0, alpha = 0;
    glBlendEquationSeparate(GL_MIN, GL_FUNC_SUBTRACT);
    glBlendEquationSeparate(GL_ONE, GL_FUNC_ADD);
    glGetIntegerv(GL_BLEND_EQUATION, &rgb);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA_EXT, &alpha);
    tell(std::to_string(rgb) + " " + std::to_string(alpha));
}

} // namespace
