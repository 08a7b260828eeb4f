// Alpha, scissor and stencil tests, blending, polygon offset and fog (OpenGL 1.5, 3.5.5, 3.10 and 4.1).

#define GL_GLEXT_PROTOTYPES
#include "scenes/common.h"

using namespace oracle;

namespace {

void rectangle(float x, float y, float width, float height)
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glVertex2f(x + (i % 2 ? width : 0), y + (i / 2 ? height : 0));
    }
    glEnd();
}

/// A strip whose alpha falls from left to right.
void fading_strip(float y, float height)
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glColor4f(0.9f, 0.7f, 0.2f, i % 2 ? 0.0f : 1.0f);
        glVertex2f(i % 2 ? 15.5f : 0.5f, y + (i / 2 ? height : 0));
    }
    glEnd();
}

void fogged(GLenum mode)
{
    const GLfloat color[] = {0.6f, 0.7f, 0.8f, 1};
    three_dimensions();
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, static_cast<GLint>(mode));
    glFogfv(GL_FOG_COLOR, color);
    glFogf(GL_FOG_DENSITY, 0.15f);
    glFogf(GL_FOG_START, 2);
    glFogf(GL_FOG_END, 12);
    for (int i = 0; i < 4; ++i) {
        glPushMatrix();
        glTranslatef(1.5f * static_cast<float>(i) - 2, 0, -3 * static_cast<float>(i));
        glRotatef(40, 1, 1, 0);
        glScalef(0.6f, 0.6f, 0.6f);
        cube();
        glPopMatrix();
    }
}

} // namespace

SCENE(alpha_functions)
{
    two_dimensions();
    glEnable(GL_ALPHA_TEST);
    for (int i = 0; i < 8; ++i) {
        glAlphaFunc(GL_NEVER + static_cast<GLenum>(i), i == 2 || i == 5 ? 128.0f / 255 : 0.4f);
        fading_strip(0.2f + 1.5f * static_cast<float>(i), 1.2f);
    }
}

SCENE(scissor_cuts_drawing_and_clearing)
{
    two_dimensions();
    glEnable(GL_SCISSOR_TEST);
    glScissor(20, 10, 70, 50);
    glClearColor(0.2f, 0.5f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(0.9f, 0.3f, 0.2f);
    rectangle(0, 0, 7, 4);
    glScissor(-10, 50, 200, 500);
    rectangle(5, 3, 7, 7);
}

SCENE(stencil_mask)
{
    two_dimensions();
    glClearStencil(1);
    glClear(GL_STENCIL_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 5, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColor3f(0.3f, 0.3f, 0.6f);
    rectangle(2, 2, 8, 8);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    rectangle(6, 4, 8, 3);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    const GLint values[] = {1, 2, 5, 6};
    for (int i = 0; i < 4; ++i) {
        glStencilFunc(GL_EQUAL, values[i], 0xff);
        glColor3f(0.25f * static_cast<float>(i), 0.9f, 0.4f);
        rectangle(0.5f, 1 + 2.5f * static_cast<float>(i), 15, 1.2f);
    }
}

SCENE(stencil_operations_and_masks)
{
    two_dimensions();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    const GLenum operations[] = {GL_ZERO, GL_INVERT, GL_DECR, GL_INCR_WRAP, GL_DECR_WRAP};
    glClearStencil(3);
    glStencilMask(0x0f);
    glClear(GL_STENCIL_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (int i = 0; i < 5; ++i) {
        glStencilFunc(GL_GEQUAL, 7, 0x07);
        glStencilOp(GL_REPLACE, operations[i], operations[(i + 1) % 5]);
        glDepthFunc(i % 2 ? GL_LESS : GL_GREATER);
        rectangle(3 * static_cast<float>(i), 1, 4, 9);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (int value = 0; value < 16; ++value) {
        glStencilFunc(GL_EQUAL, value, 0xff);
        glColor3f(static_cast<float>(value % 4) / 3, static_cast<float>(value / 4) / 3, 0.5f);
        rectangle(0, 0, 16, 12);
    }
}

SCENE(blend_equations_and_constant)
{
    two_dimensions();
    glEnable(GL_BLEND);
    const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    glBlendColor(0.3f, 0.6f, 0.9f, 0.5f);
    for (int i = 0; i < 5; ++i) {
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_ONE, GL_ZERO);
        glColor4f(0.4f, 0.6f, 0.2f, 0.6f);
        rectangle(3.1f * static_cast<float>(i) + 0.2f, 1, 2, 7);
        glBlendEquation(equations[i]);
        glBlendFunc(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA);
        glColor4f(0.9f, 0.3f, 0.7f, 0.5f);
        rectangle(3.1f * static_cast<float>(i) + 0.7f, 4, 2, 7);
    }
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    rectangle(0, 9, 16, 1);
}

SCENE(blend_by_constant_color_and_constant_alpha)
{
    two_dimensions();
    glEnable(GL_BLEND);
    const GLenum colors[] = {GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR};
    const GLenum alphas[] = {GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA};
    for (int i = 0; i < 8; ++i) {
        const GLenum color = colors[i % 2], alpha = alphas[i / 2 % 2];
        const float x = 2 * static_cast<float>(i);
        glBlendFunc(GL_ONE, GL_ZERO);
        glBegin(GL_QUADS);
        glColor4f(0, 0.2f, 1, 0.1f);
        glVertex2f(x, 0);
        glVertex2f(x + 1.8f, 0);
        glColor4f(1, 0.7f, 0.3f, 0.9f);
        glVertex2f(x + 1.8f, 12);
        glVertex2f(x, 12);
        glEnd();
        glBlendColor(0.3f, 0.6f, 0.1f * static_cast<float>(i), 0.45f);
        glBlendFuncSeparate(i < 4 ? color : alpha, i < 4 ? alpha : color, GL_CONSTANT_COLOR, GL_SRC_ALPHA);
        glBegin(GL_QUADS);
        glColor4f(0.9f, 0.1f, 0.5f, 0.2f);
        glVertex2f(x, 1);
        glColor4f(0.1f, 1, 0.8f, 0.7f);
        glVertex2f(x + 1.8f, 1);
        glVertex2f(x + 1.8f, 11);
        glColor4f(0.6f, 0.4f, 0, 1);
        glVertex2f(x, 11);
        glEnd();
    }
}

SCENE(polygon_offset_lifts_coplanar_faces)
{
    three_dimensions();
    glRotatef(-60, 1, 0, 0);
    glColor3f(0.3f, 0.4f, 0.8f);
    rectangle(-1.5f, -1.5f, 3, 3);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -2);
    glColor3f(0.9f, 0.8f, 0.3f);
    rectangle(-1, -1, 1, 2);
    glPolygonOffset(1, 2);
    glColor3f(1, 0, 0);
    rectangle(0.2f, -1, 1, 2);
}

SCENE(fog_linear)
{
    fogged(GL_LINEAR);
}

SCENE(fog_exp)
{
    fogged(GL_EXP);
}

SCENE(fog_exp2)
{
    fogged(GL_EXP2);
}

SCENE(fog_by_coordinate)
{
    two_dimensions();
    const GLfloat color[] = {0.9f, 0.9f, 0.2f, 1};
    glEnable(GL_FOG);
    glFogfv(GL_FOG_COLOR, color);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glColor3f(0.2f, 0.2f, 0.9f);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glFogCoordf(i % 2 ? 1.2f : 0.1f); // Of a negative one Mesa 22.3 takes the magnitude.
        glVertex2f(i % 2 ? 15.0f : 1.0f, i / 2 ? 11.0f : 1.0f);
    }
    glEnd();
}

SCENE(secondary_colour_sum)
{
    two_dimensions();
    glEnable(GL_COLOR_SUM);
    glBegin(GL_TRIANGLES);
    glColor3f(0.5f, 0, 0);
    glSecondaryColor3f(0, 0.8f, 0);
    glVertex2f(1, 1);
    glSecondaryColor3ub(0, 0, 200);
    glVertex2f(15, 1);
    glSecondaryColor3f(0.7f, 0.7f, 0);
    glVertex2f(1, 11);
    glEnd();
}
