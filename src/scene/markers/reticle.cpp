#include "scene/markers/reticle.h"

#include "scene/drawing/scoped_state.h"

#include <algorithm>
#include <cmath>

#include <GL/gl.h>

namespace scene {
namespace {

// Lengths in heights of the view.
constexpr float GAP = 0.012f; // about the middle, so that what is aimed at can be seen
constexpr float ARM = 0.09f;
constexpr float TICK = 0.012f;
constexpr float LINE_WIDTH = 1.0f / 400.0f; // of the window's height, and no thinner than a pixel

void line(float x0, float y0, float x1, float y1)
{
    glVertex3f(x0, y0, -1.0f);
    glVertex3f(x1, y1, -1.0f);
}

/// Draws the four arms, moved by so much, and below the middle ticks for longer ways.
void draw_lines(float x, float y)
{
    glBegin(GL_LINES);
    line(x - ARM, y, x - GAP, y);
    line(x + GAP, y, x + ARM, y);
    line(x, y + GAP, x, y + ARM);
    line(x, y - ARM, x, y - GAP);
    for (int tick = 1; tick <= 3; ++tick) {
        const float below = y - static_cast<float>(tick) * ARM / 4.0f - GAP;
        line(x - TICK, below, x + TICK, below);
    }
    glEnd();
}

} // namespace

void draw_reticle(const app::CameraView& camera, int height)
{
    const Disabled depth_test(GL_DEPTH_TEST);
    const Blended blended;
    const LineWidth width(std::max(1.0f, LINE_WIDTH * static_cast<float>(height)));
    const PushedMatrix matrix;
    glLoadIdentity(); // the eye's own frame, in which the picture's plane is a metre away
    const double scale = 2.0 * std::tan(0.5 * camera.field_of_view);
    glScaled(scale, scale, 1.0);
    const float pixel = 1.0f / static_cast<float>(height);
    glColor4ub(0, 0, 0, 150); // a shadow, so that it is seen on every ground
    draw_lines(pixel, -pixel);
    glColor4ub(255, 140, 50, 235);
    draw_lines(0.0f, 0.0f);
}

} // namespace scene
