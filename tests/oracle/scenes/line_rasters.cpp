// Stippled, wide and smooth lines (OpenGL 1.5, 3.4).

#include "scenes/common.h"

#include <cmath>

using namespace oracle;

namespace {

/// One unit a pixel, as 2D programs set it.
void pixels()
{
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, WIDTH, 0, HEIGHT);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void one_line(float x1, float y1, float x2, float y2)
{
    glBegin(GL_LINES);
    glVertex2f(x1, y1);
    glVertex2f(x2, y2);
    glEnd();
}

/// Lines from a centre to all sides, from bright to dark.
void star(float x, float y, float radius, int rays)
{
    glBegin(GL_LINES);
    for (int i = 0; i < rays; ++i) {
        const double angle = 6.283185307179586 * i / rays;
        glColor3f(1, 1, 0.5f);
        glVertex2f(x, y);
        glColor3f(1, 0.2f, 0.1f);
        glVertex2d(static_cast<double>(x) + static_cast<double>(radius) * std::cos(angle),
                   static_cast<double>(y) + static_cast<double>(radius) * std::sin(angle));
    }
    glEnd();
}

} // namespace

/// As the Red Book's lines.c.
SCENE(red_book_lines)
{
    pixels();
    glShadeModel(GL_FLAT);
    glColor3f(1, 1, 1);
    glEnable(GL_LINE_STIPPLE);
    const GLushort patterns[] = {0x0101, 0x00ff, 0x1c47};
    for (int i = 0; i < 3; ++i) {
        glLineStipple(1, patterns[i]);
        const float x = 20.0f + 40.0f * static_cast<float>(i);
        one_line(x, 100, x + 40, 100);
    }
    glLineWidth(5);
    for (int i = 0; i < 3; ++i) {
        glLineStipple(1, patterns[i]);
        const float x = 20.0f + 40.0f * static_cast<float>(i);
        one_line(x, 80, x + 40, 80);
    }
    glLineWidth(1);
    glLineStipple(1, 0x1c47);
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i < 7; ++i) {
        glVertex2f(20.0f + static_cast<float>(i) * 20.0f, 60);
    }
    glEnd();
    for (int i = 0; i < 6; ++i) {
        one_line(20.0f + static_cast<float>(i) * 20.0f, 40, 20.0f + static_cast<float>(i + 1) * 20.0f, 40);
    }
    glLineStipple(5, 0x1c47);
    one_line(20, 20, 140, 20);
    glDisable(GL_LINE_STIPPLE);
}

SCENE(stippled_star)
{
    pixels();
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x5f0f);
    star(80, 60, 56, 23);
}

SCENE(stippled_flat_loop_goes_on_around)
{
    two_dimensions();
    glShadeModel(GL_FLAT);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(3, 0x00ff);
    glBegin(GL_LINE_LOOP);
    for (int i = 0; i < 9; ++i) {
        const double angle = 6.283185307179586 * i / 9;
        glColor3f(static_cast<float>(i % 2), 1, static_cast<float>(i % 3) * 0.5f);
        glVertex2d(8 + 6 * std::cos(angle), 6 + 5 * std::sin(angle));
    }
    glEnd();
}

SCENE(stipple_of_all_ones_is_none)
{
    two_dimensions();
    glEnable(GL_LINE_STIPPLE);
    one_line(1, 1, 15, 4);
    glLineStipple(1, 0);
    one_line(1, 3, 15, 6);
    glLineStipple(1000, 0xaaaa);
    one_line(1, 5, 15, 8);
    glLineStipple(-4, 0xaaaa);
    one_line(1, 7, 15, 10);
}

SCENE(stippled_lines_in_perspective)
{
    three_dimensions();
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x0fff);
    glBegin(GL_LINES);
    for (int i = -6; i <= 6; ++i) {
        const float at = static_cast<float>(i) * 0.5f;
        glColor3f(1, 0, 0);
        glVertex3f(at, -0.8f, -3);
        glColor3f(0, 1, 1);
        glVertex3f(at, -0.8f, 4);
        glColor3f(1, 1, 0);
        glVertex3f(-3, -0.8f, at);
        glVertex3f(3, -0.8f, at);
    }
    glEnd();
}

SCENE(wide_stippled_lines)
{
    pixels();
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(4, 0x3333);
    glLineWidth(7);
    star(80, 60, 52, 11);
}

SCENE(wide_lines_of_every_width)
{
    pixels();
    for (int i = 1; i < 16; ++i) {
        glLineWidth(static_cast<float>(i) * 0.6f);
        glColor3f(1, static_cast<float>(i) / 16.0f, 0);
        one_line(5.0f + static_cast<float>(i) * 9.5f, 5, 9.0f + static_cast<float>(i) * 8.0f, 110);
    }
}

SCENE(wide_star)
{
    pixels();
    glLineWidth(6);
    star(80, 60, 50, 17);
}

SCENE(wide_lines_reach_beyond_the_viewport)
{
    pixels();
    glViewport(40, 30, 80, 60);
    glLineWidth(16);
    glColor3f(0.2f, 1, 0.4f);
    one_line(0, 4, 160, 10);
    one_line(4, -20, 10, 140);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(8, 0x5555);
    one_line(0, 118, 160, 110);
}

SCENE(very_wide_lines)
{
    pixels();
    glLineWidth(60);
    glColor3f(0.2f, 0.5f, 0.4f);
    one_line(40, 50, 120, 70);
    glLineWidth(1000);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3f(0.3f, 0.1f, 0.0f);
    one_line(80, 10, 90, 20);
}

SCENE(smooth_lines_blended)
{
    pixels();
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glHint(GL_LINE_SMOOTH_HINT, GL_DONT_CARE);
    star(80, 60, 55, 19);
}

SCENE(
    smooth_wide_lines_blended,
    {5,
     "OpenGL 1.5, 3.2 leaves open how coverage is computed. A line shorter than a pixel is as long as it is "
     "here, as in newer versions; in this one half of it.",
     {0, 22}})
{
    pixels();
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glLineWidth(4.5f);
    star(80, 60, 50, 11);
    glLineWidth(1.5f);
    one_line(10, 10, 10.3f, 10.3f);
    one_line(20, 10, 20.9f, 10);
}

SCENE(smooth_stippled_lines)
{
    pixels();
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(3, 0x0f0f);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    star(80, 60, 55, 13);
}

/// As the Red Book's aargb.c: two crossing smooth lines.
SCENE(red_book_smooth_cross)
{
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-1.333, 1.333, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glLineWidth(1.5f);
    glColor3f(0, 1, 0);
    glPushMatrix();
    glRotatef(-20, 0, 0, 0.1f);
    one_line(-0.5f, 0.5f, 0.5f, -0.5f);
    glPopMatrix();
    glColor3f(0, 0, 1);
    glRotatef(20, 0, 0, 0.1f);
    one_line(0.5f, 0.5f, -0.5f, -0.5f);
}

SCENE(lines_on_pixel_edges_and_centres)
{
    pixels();
    for (int i = 0; i < 6; ++i) {
        const float y = 10.0f + 6.0f * static_cast<float>(i) + 0.25f * static_cast<float>(i);
        glColor3f(1, 1, 1);
        one_line(10, y, 60, y);
        glColor3f(1, 0.5f, 0.5f);
        one_line(60, y, 110, y + 3);
        glColor3f(0.5f, 1, 0.5f);
        one_line(y + 50, 50, y + 50, 100);
        glColor3f(0.5f, 0.5f, 1);
        one_line(y, 100, y + 4, 50);
    }
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x3f1f);
    for (int i = 0; i < 6; ++i) {
        const float y = 12.0f + 6.0f * static_cast<float>(i) + 0.25f * static_cast<float>(i);
        glColor3f(1, 1, 0);
        one_line(110, y, 150, y);
        one_line(y + 100, 110, y + 100, 60);
    }
}
