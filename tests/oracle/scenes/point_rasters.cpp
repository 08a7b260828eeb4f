// Wide, smooth and distant points (OpenGL 1.5, 3.3).

#define GL_GLEXT_PROTOTYPES
#include "scenes/common.h"

using namespace oracle;

namespace {

void row_of_points(float y, float first_size, float step)
{
    for (int i = 0; i < 10; ++i) {
        glPointSize(first_size + step * static_cast<float>(i));
        glBegin(GL_POINTS);
        glColor3f(1, 0.1f * static_cast<float>(i), 0.2f);
        glVertex2f(1.0f + 1.5f * static_cast<float>(i), y + 0.07f * static_cast<float>(i));
        glEnd();
    }
}

} // namespace

SCENE(points_of_every_size)
{
    two_dimensions();
    row_of_points(1, 0.5f, 0.5f);
    row_of_points(4, 1.3f, 0.9f);
    row_of_points(8, 4, 1.7f);
    glPointSize(1000);
    glBegin(GL_POINTS);
    glColor3f(0, 0.2f, 0.3f);
    glVertex2f(-0.1f, 0);
    glEnd();
}

SCENE(smooth_points)
{
    two_dimensions();
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glTranslatef(0.013f, 0.017f, 0); // No pixel's centre lies exactly on a circle.
    row_of_points(1, 0.5f, 0.5f);
    row_of_points(4, 1.3f, 0.9f);
    row_of_points(8, 4, 1.7f);
}

SCENE(smooth_points_with_alpha_test)
{
    two_dimensions();
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    row_of_points(2, 4, 1);
    row_of_points(7, 7, 1.5f);
}

SCENE(points_shrink_with_distance)
{
    three_dimensions();
    const GLfloat quadratic[3] = {0, 0, 0.02f};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, quadratic);
    glPointParameterf(GL_POINT_SIZE_MIN, 2);
    glPointParameterf(GL_POINT_SIZE_MAX, 11.5f);
    glPointSize(6);
    glBegin(GL_POINTS);
    for (int i = 0; i < 60; ++i) {
        glColor3f(1, static_cast<float>(i) / 60.0f, 0.3f);
        glVertex3f(static_cast<float>(i % 10) * 0.4f - 2, static_cast<float>(i / 10) * 0.4f - 1,
                   3 - static_cast<float>(i * 7 % 60) * 0.15f);
    }
    glEnd();
}

SCENE(smooth_points_shrink_with_distance)
{
    three_dimensions();
    const GLfloat linear[3] = {0.2f, 0.1f, 0};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, linear);
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPointSize(9);
    glBegin(GL_POINTS);
    for (int i = 0; i < 40; ++i) {
        glColor3f(0.4f, static_cast<float>(i) / 40.0f, 1);
        glVertex3f(static_cast<float>(i % 8) * 0.5f - 2, static_cast<float>(i / 8) * 0.5f - 1,
                   2 - static_cast<float>(i * 7 % 40) * 0.2f);
    }
    glEnd();
}
