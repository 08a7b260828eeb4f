// Depth, blending, culling and masks (OpenGL 1.5, chapter 4 and 3.5.1).

#include "scenes/common.h"

using namespace oracle;

namespace {

void rectangle(float x, float y, float width, float height, float z)
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glVertex3f(x + (i % 2 ? width : 0), y + (i / 2 ? height : 0), z);
    }
    glEnd();
}

} // namespace

SCENE(depth_functions)
{
    two_dimensions();
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 8; ++i) {
        const float x = static_cast<float>(2 * i) + 0.2f;
        glDepthFunc(GL_ALWAYS);
        glColor3f(0.3f, 0.3f, 0.8f);
        rectangle(x, 1, 1.6f, 6, 0);
        glDepthFunc(GL_NEVER + static_cast<GLenum>(i));
        for (int k = -1; k <= 1; ++k) {
            glColor3f(0.9f, 0.5f + 0.4f * static_cast<float>(k), 0.1f);
            rectangle(x + 0.2f, static_cast<float>(3 * k) + 4.5f, 1.2f, 1.5f, 0.5f * static_cast<float>(k));
        }
    }
}

SCENE(depth_mask_and_range)
{
    three_dimensions();
    glRotatef(20, 1, 1, 0);
    glDepthMask(GL_FALSE);
    cube();
    glDepthMask(GL_TRUE);
    glDepthRange(0.9, 1.0);
    glTranslatef(1, 0, 1);
    cube();
    glDepthRange(0.0, 0.5);
    glTranslatef(-2, 0, -2);
    cube();
}

SCENE(blend_functions)
{
    two_dimensions();
    glEnable(GL_BLEND);
    const GLenum factors[][2] = {{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA},
                                 {GL_ONE, GL_ONE},
                                 {GL_DST_COLOR, GL_ZERO},
                                 {GL_ZERO, GL_ONE_MINUS_SRC_COLOR},
                                 {GL_SRC_ALPHA_SATURATE, GL_ONE},
                                 {GL_ONE_MINUS_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA},
                                 {GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA}};
    for (int i = 0; i < 7; ++i) {
        glBlendFunc(GL_ONE, GL_ZERO);
        glColor4f(0.2f, 0.5f, 0.8f, 0.6f);
        rectangle(2.2f * static_cast<float>(i) + 0.2f, 1, 1.8f, 6, 0);
        glBlendFunc(factors[i][0], factors[i][1]);
        glColor4f(0.9f, 0.4f, 0.1f, 0.5f);
        rectangle(2.2f * static_cast<float>(i) + 0.7f, 4, 1.8f, 6, 0);
    }
}

SCENE(cull_and_front_face)
{
    three_dimensions();
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    const GLenum faces[] = {GL_BACK, GL_FRONT, GL_FRONT_AND_BACK};
    for (int face = 0; face < 3; ++face) {
        for (int winding = 0; winding < 2; ++winding) {
            glCullFace(faces[face]);
            glFrontFace(winding ? GL_CW : GL_CCW);
            glPushMatrix();
            glTranslatef(1.5f * static_cast<float>(face) - 1.5f, winding ? 0.8f : -0.8f, 0);
            glRotatef(30, 1, 1, 0);
            glScalef(0.4f, 0.4f, 0.4f);
            cube();
            glPopMatrix();
        }
    }
}

SCENE(colour_mask_and_clear)
{
    two_dimensions();
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glColor3f(1, 1, 1);
    rectangle(1, 1, 8, 8, 0);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    glClearColor(0.5f, 0.6f, 0.7f, 0.8f);
    glClear(GL_COLOR_BUFFER_BIT);
    rectangle(6, 4, 8, 7, 0);
}

SCENE(viewports_and_nested_matrices)
{
    three_dimensions();
    for (int i = 0; i < 4; ++i) {
        glViewport(80 * (i % 2), 60 * (i / 2), 80, 60);
        glPushMatrix();
        for (int k = 0; k < 5; ++k) {
            glPushMatrix();
            glRotatef(static_cast<float>(17 * k + 31 * i), 0.3f, 1, 0.2f);
            glTranslated(0.4 * k - 0.8, 0, 0);
            glScaled(0.2, 0.3, 0.2);
            cube();
            glPopMatrix();
            glRotated(15, 0, 0, 1);
        }
        glPopMatrix();
    }
}

SCENE(matrix_stacks_and_their_errors)
{
    two_dimensions();
    const auto error = [](const char* what) {
        tell(std::string(what) + " " + std::to_string(oracle::next_error()));
    };
    glPopMatrix();
    error("pop of the last");
    for (int i = 0; i < 31; ++i) {
        glPushMatrix();
    }
    error("31 pushes");
    glPushMatrix();
    error("one too many");
    glMatrixMode(GL_LINES);
    error("mode");
    glFrustum(-1, 1, -1, 1, 0, 10);
    error("near 0");
    glOrtho(1, 1, 0, 1, 0, 1);
    error("no width");
    glViewport(0, 0, -1, 5);
    error("negative size");
    GLint mode = 0, viewport[4];
    glGetIntegerv(GL_MATRIX_MODE, &mode);
    glGetIntegerv(GL_VIEWPORT, viewport);
    tell(std::to_string(mode) + " " + std::to_string(viewport[2]));
    glGetIntegerv(0x7777, &mode);
    error("unknown name");
    GLfloat matrix[16];
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glRotatef(33, 1, 2, 3);
    glTranslatef(1, 2, 3);
    glScalef(2, 2, 2);
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    for (float m : matrix) {
        tell(std::to_string(m));
    }
}
