// User clip planes (OpenGL 1.5, 2.12).

#include "scenes/common.h"

using namespace oracle;

namespace {

void plane(int i, double a, double b, double c, double d)
{
    const GLdouble equation[4] = {a, b, c, d};
    glClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), equation);
    glEnable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
}

void light()
{
    const GLfloat position[4] = {1, 2, 3, 0}, white[4] = {1, 1, 1, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
}

} // namespace

/// As the Red Book's clip.c: a quarter of a wire sphere.
SCENE(red_book_clip)
{
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, static_cast<double>(WIDTH) / HEIGHT, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glColor3f(1, 1, 1);
    glTranslatef(0, 0, -2.2f);
    plane(0, 0, 1, 0, 0);
    plane(1, 1, 0, 0, 0);
    glRotatef(90, 1, 0, 0);
    GLUquadric* quadric = gluNewQuadric();
    gluQuadricDrawStyle(quadric, GLU_LINE);
    gluSphere(quadric, 1, 20, 16);
    gluDeleteQuadric(quadric);
}

SCENE(clipped_lit_torus)
{
    three_dimensions();
    light();
    glRotatef(60, 1, 0.2f, 0);
    plane(0, 0.3, 0.5, 1, 0.1);
    torus(1.2f, 0.5f, 16, 24);
}

SCENE(clipped_flat_torus)
{
    three_dimensions();
    light();
    glShadeModel(GL_FLAT);
    glRotatef(60, 1, 0.2f, 0);
    plane(3, 0.3, 0.5, 1, 0.1);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(clipped_by_six_planes)
{
    three_dimensions();
    glRotatef(30, 1, 1, 0);
    plane(0, 1, 0, 0, 0.8);
    plane(1, -1, 0, 0, 0.9);
    plane(2, 0, 1, 0, 0.7);
    plane(3, 0, -1, 0, 0.8);
    plane(4, 0, 0.2, 1, 0.9);
    plane(5, 0.5, 0, -1, 0.9);
    cube();
}

SCENE(clipped_wireframe_shows_the_cut)
{
    three_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRotatef(30, 1, 1, 0);
    plane(0, 1, 0.4, 0.2, 0.3);
    cube();
}

SCENE(clipped_polygon_points)
{
    three_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(5);
    glRotatef(30, 1, 1, 0);
    plane(0, 1, 0.4, 0.2, 0.3);
    cube();
}

SCENE(clipped_points_and_lines)
{
    two_dimensions();
    plane(0, 1, 1, 0, -8.3);
    plane(2, -1, 0.5, 0, 9.1);
    glPointSize(4);
    glBegin(GL_POINTS);
    for (int i = 0; i < 16 * 12; ++i) {
        glVertex2i(i % 16, i / 16);
    }
    glEnd();
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i < 40; ++i) {
        glColor3f(1, static_cast<float>(i % 5) * 0.25f, 0);
        glVertex2f(static_cast<float>(i) * 0.4f, i % 2 ? 0.5f : 11.3f);
    }
    glEnd();
}

SCENE(clipped_stippled_lines)
{
    two_dimensions();
    plane(0, 1, 0, 0, -4.1);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x7333);
    for (int i = 0; i < 12; ++i) {
        glBegin(GL_LINES);
        glVertex2f(0.5f, static_cast<float>(i) + 0.3f);
        glVertex2f(15.5f, static_cast<float>(i) * 0.8f + 0.5f);
        glEnd();
    }
}

SCENE(clip_plane_is_transformed_when_given)
{
    three_dimensions();
    glPushMatrix();
    glRotatef(45, 0, 0, 1);
    glTranslatef(0.2f, 0, 0);
    plane(0, 1, 0, 0, 0);
    glPopMatrix();
    glRotatef(20, 1, 1, 0);
    cube();
    for (int p = 0; p < 2; ++p) {
        GLdouble equation[4] = {9, 9, 9, 9};
        glGetClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(p), equation);
        for (const double e : equation) {
            tell(std::to_string(static_cast<float>(e)));
        }
    }
}

SCENE(clip_planes_that_cut_nothing_and_all)
{
    three_dimensions();
    plane(0, 0, 0, 0, 1);
    glRotatef(20, 1, 1, 0);
    cube();
    plane(1, 0, 0, 0, -1);
    glScalef(1.5f, 1.5f, 1.5f);
    cube();
}

SCENE(clipped_textured_quads_from_a_list)
{
    three_dimensions();
    const GLubyte texels[4 * 4] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    cube();
    glEndList();
    glRotatef(30, 1, 1, 0);
    plane(0, 1, 0.4, 0.2, 0.3);
    glCallList(list);
}

SCENE(clipped_quads_with_offset_and_culling)
{
    three_dimensions();
    glEnable(GL_CULL_FACE);
    glRotatef(30, 1, 1, 0);
    plane(0, 1, 0.4, 0.2, 0.3);
    cube();
    glDisable(GL_CLIP_PLANE0);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -2);
    glColor3f(1, 1, 1);
    plane(1, -0.2, 0.3, 1, -0.2);
    cube();
}
