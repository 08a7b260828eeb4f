/* A lit cube in a display list, turning: OpenGL 1.1 as books have it, and nothing of legacygl. */
#include "program.h"

#include <GL/gl.h>
#include <GL/glu.h>

static GLuint cube;

static void face(float red, float green, float blue)
{
    glColor3f(red, green, blue);
    glNormal3f(0, 0, 1);
    glBegin(GL_QUADS);
    glVertex3f(-1, -1, 1);
    glVertex3f(1, -1, 1);
    glVertex3f(1, 1, 1);
    glVertex3f(-1, 1, 1);
    glEnd();
}

void set_up(void)
{
    const GLfloat towards_light[] = {1, 2, 3, 0};
    int side;

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(40, (double)WIDTH / HEIGHT, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0, 0, 7, 0, 0, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, towards_light);

    cube = glGenLists(1);
    glNewList(cube, GL_COMPILE);
    for (side = 0; side < 4; ++side) {
        face(0.9f, 0.3f + 0.2f * (float)side, 0.2f);
        glRotatef(90, 0, 1, 0);
    }
    glRotatef(90, 1, 0, 0);
    face(0.2f, 0.5f, 0.9f);
    glRotatef(180, 1, 0, 0);
    face(0.3f, 0.8f, 0.4f);
    glEndList();
}

void draw(double seconds)
{
    glClearColor(0.1f, 0.1f, 0.15f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotated(30 * seconds, 0.6, 0.8, 0);
    glCallList(cube);
    glPopMatrix();
}
