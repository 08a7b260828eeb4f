// What random programs found: in which order Mesa draws the halves of quads, and what it leaves uncut.

#define GL_GLEXT_PROTOTYPES
#include "scenes/common.h"

#include <cmath>

namespace {

/// A strip whose quads cross themselves, half transparent: which half comes first is seen.
void folded_strip(float left, float bottom, float height)
{
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i < 6; ++i) {
        const float x = left + 1.1f * static_cast<float>(i);
        glColor4f(0.2f * static_cast<float>(i), 0.9f, 0.3f, 0.4f);
        glVertex2f(x, bottom + (i % 2 == 0 ? 0.0f : height));
        glColor4f(1, 0.15f * static_cast<float>(i), 0.6f, 0.7f);
        glVertex2f(x + 0.9f, bottom + (i % 2 == 0 ? height : 0.0f));
    }
    glEnd();
}

SCENE(folded_quad_strips_inside_and_cut)
{
    oracle::two_dimensions();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    folded_strip(1, 1, 4);
    folded_strip(11, 1, 4); // reaches out of the view
    glShadeModel(GL_FLAT);
    folded_strip(1, 6.5f, 4);
    folded_strip(-3, 6.5f, 4);
}

SCENE(rectangle_flat_under_a_light_at_a_place)
{
    oracle::three_dimensions();
    const GLfloat place[] = {0.5f, 0.3f, 0.8f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, place);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.7f);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
    glShadeModel(GL_FLAT);
    glNormal3f(0, 0, 1);
    for (int i = 0; i < 4; ++i) {
        glRectf(static_cast<float>(i) - 2, -1, static_cast<float>(i) - 1.1f, 1.2f);
    }
}

SCENE(smooth_points_attenuated_below_a_pixel)
{
    oracle::three_dimensions();
    const GLfloat attenuation[] = {0, 0, 0.3f};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    glPointParameterf(GL_POINT_SIZE_MIN, 0.3f);
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int size = 0; size < 4; ++size) {
        glPointSize(1 + 3 * static_cast<float>(size));
        glBegin(GL_POINTS);
        for (int i = 0; i < 14; ++i) {
            glVertex3f(0.25f * static_cast<float>(i) - 1.7f, 0.4f * static_cast<float>(size) - 0.6f,
                       3.6f - 0.9f * static_cast<float>(i));
        }
        glEnd();
    }
}

SCENE(inverted_triangles_cut_by_the_view_alone)
{
    oracle::three_dimensions();
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_INVERT);
    glDepthFunc(GL_ALWAYS);
    for (int i = 0; i < 7; ++i) {
        const double angle = 0.9 * i;
        const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
        glBegin(GL_TRIANGLES);
        glVertex3f(0.2f * c, 0.2f * s, 4.5f); // behind the near plane
        glVertex3f(5 * c - s, 5 * s + c, -3);
        glVertex3f(5 * c + s, 5 * s - c, -1);
        glEnd();
    }
}

} // namespace
