// Quadrics (GLU 1.3, chapter 6): every shape × draw style × normals × orientation, plain and textured.
//
// Flat normals of points and silhouettes are never filled in by libGLU 9.0.2 (it gives what was in memory),
// so those tiles are drawn without light.

#include "scenes/common.h"

using namespace oracle;

namespace {

void checker()
{
    GLubyte pixels[8][8][3];
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const bool light = (x + y) % 2 == 0;
            pixels[y][x][0] = static_cast<GLubyte>(light ? 255 : 60 + 20 * x);
            pixels[y][x][1] = static_cast<GLubyte>(light ? 200 : 40);
            pixels[y][x][2] = static_cast<GLubyte>(light ? 30 * y : 160);
        }
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// Clears, and sets one white light and a texture.
void prepare()
{
    glClearColor(0.1f, 0.1f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    const GLfloat position[] = {1, 2, 3, 0}, specular[] = {0.6f, 0.6f, 0.6f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
    checker();
}

/// Makes a tile of 40 × 40 pixels the viewport, with a camera that looks at the origin from above.
void tile(int column, int row)
{
    glViewport(40 * column, 40 * row, 40, 40);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(30, 1, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(1.5, 2.5, 4, 0, 0, 0, 0, 1, 0);
}

using Shape = void (*)(GLUquadric*);

void sphere(GLUquadric* quadric)
{
    gluSphere(quadric, 1.1, 11, 7);
}

void cylinder(GLUquadric* quadric)
{
    glTranslatef(0, 0, -0.8f);
    gluCylinder(quadric, 1, 0.4, 1.7, 9, 3);
}

void disk(GLUquadric* quadric)
{
    gluDisk(quadric, 0, 1.2, 10, 3);
}

void partial_disk(GLUquadric* quadric)
{
    gluPartialDisk(quadric, 0.35, 1.2, 8, 2, 40, 230);
}

/// Draws a shape in a style: a row for each kind of normals, columns outside, inside, and both textured.
void grid(Shape shape, GLenum style)
{
    prepare();
    GLUquadric* quadric = gluNewQuadric();
    gluQuadricDrawStyle(quadric, style);
    const GLenum normals[] = {GLU_SMOOTH, GLU_FLAT, GLU_NONE};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            tile(column, row);
            const bool flat = normals[row] == GLU_FLAT, textured = column >= 2;
            const bool has_normals = !flat || style == GLU_FILL || style == GLU_LINE;
            (has_normals ? glEnable : glDisable)(GL_LIGHTING);
            (textured ? glEnable : glDisable)(GL_TEXTURE_2D);
            glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
            glNormal3f(0, 0, 1);
            glColor3f(0.9f, 0.7f, 0.3f);
            glPointSize(2);
            gluQuadricNormals(quadric, normals[row]);
            gluQuadricOrientation(quadric, column % 2 == 0 ? GLU_OUTSIDE : GLU_INSIDE);
            gluQuadricTexture(quadric, textured);
            shape(quadric);
        }
    }
    gluDeleteQuadric(quadric);
}

void tell_error(GLenum code)
{
    tell("quadric error " + std::to_string(code));
}

} // namespace

SCENE(glu_sphere_fill)
{
    grid(sphere, GLU_FILL);
}
SCENE(glu_sphere_line)
{
    grid(sphere, GLU_LINE);
}
SCENE(glu_sphere_silhouette)
{
    grid(sphere, GLU_SILHOUETTE);
}
SCENE(glu_sphere_point)
{
    grid(sphere, GLU_POINT);
}
SCENE(glu_cylinder_fill)
{
    grid(cylinder, GLU_FILL);
}
SCENE(glu_cylinder_line)
{
    grid(cylinder, GLU_LINE);
}
SCENE(glu_cylinder_silhouette)
{
    grid(cylinder, GLU_SILHOUETTE);
}
SCENE(glu_cylinder_point)
{
    grid(cylinder, GLU_POINT);
}
SCENE(glu_disk_fill)
{
    grid(disk, GLU_FILL);
}
SCENE(glu_disk_line, {4, LAST_BIT_DECIDES, {26}})
{
    grid(disk, GLU_LINE);
}
SCENE(glu_disk_silhouette)
{
    grid(disk, GLU_SILHOUETTE);
}
SCENE(glu_disk_point)
{
    grid(disk, GLU_POINT);
}
SCENE(glu_partial_disk_fill)
{
    grid(partial_disk, GLU_FILL);
}
SCENE(glu_partial_disk_line)
{
    grid(partial_disk, GLU_LINE);
}
SCENE(glu_partial_disk_silhouette)
{
    grid(partial_disk, GLU_SILHOUETTE);
}
SCENE(glu_partial_disk_point)
{
    grid(partial_disk, GLU_POINT);
}

SCENE(glu_quadrics_of_extreme_divisions)
{
    prepare();
    glEnable(GL_LIGHTING);
    glColor3f(0.3f, 0.8f, 0.9f);
    GLUquadric* quadric = gluNewQuadric();
    // More than 239 divisions are drawn as 239.
    tile(0, 0);
    gluSphere(quadric, 1.1, 300, 300);
    tile(1, 0);
    gluCylinder(quadric, 0.8, 0.8, 1, 240, 1);
    tile(2, 0);
    gluDisk(quadric, 0.3, 1.2, 1000, 20);
    tile(3, 0);
    gluSphere(quadric, 1.1, 2, 2);
    tile(0, 1);
    gluSphere(quadric, 1.1, 5, 1);
    tile(1, 1);
    gluCylinder(quadric, 1, 0, 1.5, 2, 1);
    tile(2, 1);
    gluDisk(quadric, 0, 1.2, 2, 1);
    tile(3, 1);
    gluDisk(quadric, 0, 1.2, 3, 1);
    tile(0, 2);
    gluCylinder(quadric, 0, 1, 1.5, 16, 4); // a cone that stands on its tip
    tile(1, 2);
    gluCylinder(quadric, 1, 0.2, 0, 16, 4); // flat
    tile(2, 2);
    gluSphere(quadric, 1.1, 32, 32);
    tile(3, 2);
    gluPartialDisk(quadric, 0.2, 1.2, 16, 2, -30, -500);
    gluDeleteQuadric(quadric);
}

SCENE(glu_partial_disks_of_all_angles)
{
    prepare();
    GLUquadric* quadric = gluNewQuadric();
    const double angles[12][2] = {{0, 90},    {90, 90},    {0, -90},  {-45, 10}, {350, 30},    {0, 360},
                                  {10, -360}, {700, 22.5}, {0, -500}, {0, 500},  {33.3, 77.7}, {180, 180}};
    for (int i = 0; i < 12; ++i) {
        tile(i % 4, i / 4);
        glColor3f(0.9f, 0.5f, 0.4f);
        gluQuadricDrawStyle(quadric, GLU_FILL);
        gluPartialDisk(quadric, i % 3 == 0 ? 0 : 0.4, 0.9, 7, 2, angles[i][0], angles[i][1]);
        glColor3f(1, 1, 1);
        gluQuadricDrawStyle(quadric, i % 2 == 0 ? GLU_SILHOUETTE : GLU_LINE);
        gluPartialDisk(quadric, i % 5 == 0 ? 1.2 : 1, 1.2, 7, 2, angles[i][0], angles[i][1]);
    }
    gluDeleteQuadric(quadric);
}

SCENE(glu_quadrics_in_lists)
{
    prepare();
    glEnable(GL_LIGHTING);
    glEnable(GL_CULL_FACE);
    GLUquadric* quadric = gluNewQuadric();
    gluQuadricTexture(quadric, GL_TRUE);
    glEnable(GL_TEXTURE_2D);
    const GLuint list = glGenLists(3);
    glNewList(list, GL_COMPILE);
    gluSphere(quadric, 0.6, 12, 8);
    glEndList();
    glNewList(list + 1, GL_COMPILE);
    gluCylinder(quadric, 0.5, 0.5, 1.2, 12, 2);
    glEndList();
    glNewList(list + 2, GL_COMPILE);
    gluDisk(quadric, 0, 0.5, 12, 2);
    glEndList();
    gluDeleteQuadric(quadric); // The lists keep what was drawn.
    glMatrixMode(GL_PROJECTION);
    gluPerspective(40, static_cast<double>(WIDTH) / HEIGHT, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0, 1, 5, 0, 0, 0, 0, 1, 0);
    for (int i = 0; i < 3; ++i) {
        glPushMatrix();
        glTranslatef(1.5f * static_cast<float>(i - 1), 0, 0);
        glRotatef(30, 1, 0.5f, 0);
        glColor3f(0.4f + 0.3f * static_cast<float>(i), 0.8f, 1 - 0.3f * static_cast<float>(i));
        glCallList(list + static_cast<GLuint>(i));
        glPopMatrix();
    }
}

SCENE(glu_quadric_errors)
{
    two_dimensions();
    GLUquadric* quadric = gluNewQuadric();
    gluSphere(quadric, 1, 1, 1); // Without a callback nobody hears of it.
    gluQuadricCallback(quadric, GLU_ERROR, reinterpret_cast<_GLUfuncptr>(tell_error));
    gluQuadricCallback(quadric, GLU_TESS_VERTEX, nullptr);
    gluQuadricDrawStyle(quadric, GL_FILL);
    gluQuadricNormals(quadric, GLU_FILL);
    gluQuadricOrientation(quadric, GL_FRONT);
    tell("spheres");
    gluSphere(quadric, -1, 5, 5);
    gluSphere(quadric, 1, 1, 5);
    gluSphere(quadric, 1, 5, 0);
    tell("cylinders");
    gluCylinder(quadric, 1, 1, 1, 1, 1);
    gluCylinder(quadric, 1, 1, 1, 5, 0);
    gluCylinder(quadric, -1, 1, 1, 5, 1);
    gluCylinder(quadric, 1, -1, 1, 5, 1);
    gluCylinder(quadric, 1, 1, -1, 5, 1);
    gluCylinder(quadric, 1, 1, 0, 5, 1);
    tell("disks");
    gluDisk(quadric, -1, 1, 5, 1);
    gluDisk(quadric, 0, 0, 5, 1);
    gluDisk(quadric, 2, 1, 5, 1);
    gluDisk(quadric, 0, 1, 1, 1);
    gluPartialDisk(quadric, 0, 1, 5, 0, 0, 90);
    tell("good ones");
    glTranslatef(8, 6, 0);
    gluDisk(quadric, 1, 4, 12, 1);
    gluSphere(quadric, 0, 5, 5);
    gluQuadricCallback(quadric, GLU_ERROR, nullptr);
    gluDisk(quadric, 2, 1, 5, 1);
    gluDeleteQuadric(quadric);
    gluDeleteQuadric(nullptr);
}
