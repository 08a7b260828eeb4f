// Logic ops on colours (OpenGL 1.5, 4.1.10).

#include "scenes/common.h"

using namespace oracle;

namespace {

/// Two colours that differ in every bit pair, and something under them.
void background()
{
    two_dimensions();
    glColor3ub(0xcc, 0x0f, 0xf0);
    glRectf(0, 0, 16, 4);
    glColor3ub(0x33, 0xaa, 0x55);
    glRectf(0, 4, 16, 8);
}

} // namespace

SCENE(all_logic_ops)
{
    background();
    glEnable(GL_COLOR_LOGIC_OP);
    for (int op = 0; op < 16; ++op) {
        glLogicOp(GL_CLEAR + static_cast<GLenum>(op));
        const float x = static_cast<float>(op);
        glColor4ub(0x5a, 0x3c, 0x96, 0x0f);
        glRectf(x + 0.1f, 1, x + 0.9f, 11);
    }
}

SCENE(exclusive_or_twice_is_nothing)
{
    background();
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
    glColor3f(1, 1, 0);
    glRectf(1, 1, 9, 9);
    glRectf(1, 1, 9, 9);
    glRectf(5, 2, 15, 10);
    glBegin(GL_LINE_LOOP);
    glVertex2f(2, 2);
    glVertex2f(14, 3);
    glVertex2f(12, 11);
    glVertex2f(3, 10);
    glEnd();
}

SCENE(inverted_primitives_that_overlap)
{
    background();
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_INVERT);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 9; ++i) {
        glVertex2f(1.0f + 1.5f * static_cast<float>(i), i % 3 == 1 ? 11.0f : 1.0f);
    }
    glEnd();
    glLineWidth(5);
    glPointSize(12);
    glBegin(GL_LINES);
    glVertex2f(1, 2);
    glVertex2f(15, 9);
    glVertex2f(1, 9);
    glVertex2f(15, 2);
    glEnd();
    glBegin(GL_POINTS);
    glVertex2f(8, 6);
    glVertex2f(8.5f, 6);
    glEnd();
}

SCENE(logic_op_copies_without_blending)
{
    background();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3f(0.2f, 0.4f, 0.6f);
    glRectf(1, 1, 5, 11);
    glEnable(GL_COLOR_LOGIC_OP);
    glRectf(6, 1, 10, 11);
    glLogicOp(GL_OR);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glRectf(11, 1, 15, 11);
}
