#pragma once

#include "scene.h"

#include <GL/gl.h>
#include <GL/glu.h>

namespace oracle {

/// Clears to a dark blue and sets a perspective and a camera at z = 5.
inline void three_dimensions()
{
    glClearColor(0.1f, 0.1f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, static_cast<double>(WIDTH) / HEIGHT, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 1, 5, 0, 0, 0, 0, 1, 0);
}

/// Clears to a dark grey and maps (0, 0) … (16, 12) onto the picture.
inline void two_dimensions()
{
    glClearColor(0.15f, 0.15f, 0.15f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 16, 0, 12, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/// Draws a torus around the y axis, its normals outward and texture coordinates around both circles.
void torus(float large, float small, int sides, int rings);

/// Draws a cube of edge 2 with a normal, a colour and texture coordinates a face.
void cube();

} // namespace oracle
