// Viewports that are smaller or larger than the window, and their limits.

#include "scenes/common.h"

#include <string>

namespace {

SCENE(points_reach_beyond_a_small_viewport)
{
    glClearColor(0.2f, 0.2f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 6; ++i) {
        glViewport(10 + 25 * i, 15 + 15 * i, 1 + 3 * i, 1 + 2 * i);
        glPointSize(3 + 2.5f * static_cast<float>(i));
        glColor3f(1, 0.2f * static_cast<float>(i), 0);
        glBegin(GL_POINTS);
        glVertex2f(0, 0);
        glVertex2f(1, 1);
        glVertex2f(1.01f, 0);
        glEnd();
    }
}

SCENE(lines_reach_beyond_a_small_viewport)
{
    glClearColor(0.2f, 0.2f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (int width = 1; width < 8; width += 2) {
        glViewport(10 + 18 * width, 20, 12, 60);
        glLineWidth(static_cast<float>(width));
        glBegin(GL_LINE_LOOP);
        glVertex2f(-1, -1);
        glVertex2f(1, -1);
        glVertex2f(1, 1);
        glVertex2f(-1, 1);
        glEnd();
    }
}

SCENE(viewport_larger_than_the_window)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glViewport(-100, -50, 500, 400);
    glRotatef(30, 1, 1, 0);
    glScalef(0.3f, 0.3f, 0.3f);
    oracle::cube();
    glLoadIdentity();
    glViewport(-2000, -2000, 4160, 4120);
    glColor3f(0, 1, 0);
    glLineWidth(3);
    glBegin(GL_LINES);
    glVertex2f(-1, -1);
    glVertex2f(1, 1);
    glEnd();
}

SCENE(viewport_is_cut_to_the_greatest)
{
    GLint limits[2], viewport[4];
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, limits);
    glViewport(0, 0, 100000, 200000);
    glGetIntegerv(GL_VIEWPORT, viewport);
    for (const GLint value : viewport) {
        oracle::tell(std::to_string(value));
    }
    oracle::tell(std::to_string(limits[0]) + " " + std::to_string(limits[1]));
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(-1, -1);
    glColor3f(0, 1, 0);
    glVertex2f(1, -1);
    glColor3f(0, 0, 1);
    glVertex2f(-1, 1);
    glEnd();
}

SCENE(empty_and_narrow_viewports)
{
    glViewport(20, 20, 0, 0);
    glRectf(-1, -1, 1, 1);
    glViewport(30, 30, 7, 1);
    glBegin(GL_LINES);
    glVertex2f(-1, 0);
    glVertex2f(1, 0);
    glEnd();
    glViewport(40, 40, 1, 7);
    glBegin(GL_LINES);
    glVertex2f(0, -1);
    glVertex2f(0, 1);
    glEnd();
    glViewport(50, 50, 2, 3);
    glRectf(-1, -1, 1, 1);
}

SCENE(vertices_behind_the_eye_and_at_infinity)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex4f(-0.5f, -0.5f, 0, 1);
    glColor3f(0, 1, 0);
    glVertex4f(0.5f, -0.5f, 0, 1);
    glColor3f(0, 0, 1);
    glVertex4f(0, -0.5f, 0, -1);
    glVertex4f(-0.5f, 0, 0, -1);
    glVertex4f(0.5f, 0, 0, -1);
    glVertex4f(0, 0.5f, 0, -1);
    glEnd();
    glBegin(GL_LINES);
    glVertex4f(0, 0, 0, 1);
    glVertex4f(-1, 0.3f, 0, 0);
    glVertex2f(-1e9f, -1e9f);
    glVertex2f(1e9f, 0.7e9f);
    glEnd();
    glBegin(GL_POINTS);
    glVertex4f(0, 0, 0, 0);
    glVertex4f(0.1f, 0.1f, 0.1f, -1);
    glVertex2f(-0.9f, 0.9f);
    glEnd();
}

SCENE(flattening_and_mirroring_matrices_light)
{
    oracle::three_dimensions();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glTranslatef(-1.2f, 0, 0);
    glPushMatrix();
    glScalef(1, 1, 0);
    oracle::torus(0.8f, 0.3f, 8, 12);
    glPopMatrix();
    glTranslatef(2.4f, 0, 0);
    glScalef(-1, 0.7f, -0.9f);
    glEnable(GL_NORMALIZE);
    glFrontFace(GL_CW);
    glEnable(GL_CULL_FACE);
    oracle::torus(0.8f, 0.3f, 8, 12);
}

/// A quad of a list is cut along another diagonal, but not when it is executed while the list is made.
SCENE(quads_compiled_and_executed_are_cut_as_those_drawn_at_once)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glScalef(0.45f, 0.9f, 1);
    glTranslatef(-1, 0, 0);
    for (int i = 0; i < 2; ++i) {
        glNewList(1, GL_COMPILE_AND_EXECUTE);
        glBegin(GL_QUADS);
        glColor3f(1, 0, 0);
        glVertex2f(-0.9f, -0.9f);
        glColor3f(0, 1, 0);
        glVertex2f(0.9f, -0.9f);
        glColor3f(0, 0, 1);
        glVertex2f(0.9f, 0.9f);
        glColor3f(1, 1, 0);
        glVertex2f(-0.9f, 0.9f);
        glEnd();
        glEndList();
        glTranslatef(2, 0, 0);
    }
}

SCENE(level_of_detail_biased_by_unit_and_texture)
{
    oracle::two_dimensions();
    GLubyte texels[64 * 64 * 3];
    for (int i = 0; i < 64 * 64 * 3; ++i) {
        texels[i] = static_cast<GLubyte>(i * 29);
    }
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 64, 64, GL_RGB, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glEnable(GL_TEXTURE_2D);
    for (int i = 0; i < 6; ++i) {
        const float left = 2.6f * static_cast<float>(i) + 0.2f;
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0.75f * static_cast<float>(i % 3));
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, i < 3 ? 0.0f : -0.5f);
        glBegin(GL_QUADS);
        glTexCoord2f(0, 0);
        glVertex2f(left, 1);
        glTexCoord2f(1, 0);
        glVertex2f(left + 2.4f, 1);
        glTexCoord2f(1, 3);
        glVertex2f(left + 2.4f, 11);
        glTexCoord2f(0, 3);
        glVertex2f(left, 11);
        glEnd();
    }
    GLfloat unit = -1, texture = -1;
    glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &unit);
    glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, &texture);
    oracle::tell(std::to_string(unit) + " " + std::to_string(texture));
}

SCENE(limits_and_ranges)
{
    // The greatest size is the implementation's; OpenGL 1.5, table 6.27, asks for 1.
    for (const GLenum name : {GL_POINT_SIZE_RANGE, GL_LINE_WIDTH_RANGE, GL_ALIASED_POINT_SIZE_RANGE,
                              GL_ALIASED_LINE_WIDTH_RANGE}) {
        GLfloat values[2] = {-7, -7};
        glGetFloatv(name, values);
        oracle::tell(std::to_string(values[0]) + (values[1] >= 1 ? " and more" : " alone"));
    }
    for (const GLenum name :
         {GL_POINT_SIZE_GRANULARITY, GL_LINE_WIDTH_GRANULARITY, GL_MAX_TEXTURE_LOD_BIAS,
          GL_MAX_NAME_STACK_DEPTH, GL_NAME_STACK_DEPTH, GL_MAX_VIEWPORT_DIMS, GL_AUTO_NORMAL}) {
        GLfloat values[2] = {-7, -7};
        glGetFloatv(name, values);
        oracle::tell(std::to_string(values[0]) + " " + std::to_string(values[1]));
    }
    glEnable(GL_AUTO_NORMAL);
    glPushAttrib(GL_EVAL_BIT);
    glDisable(GL_AUTO_NORMAL);
    glPopAttrib();
    oracle::tell(std::to_string(glIsEnabled(GL_AUTO_NORMAL)));
    glTexImage2D(GL_TEXTURE_2D, 40, 3, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
}

} // namespace
