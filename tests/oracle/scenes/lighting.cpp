// Lighting and materials (OpenGL 1.5, 2.14).

#include "scenes/common.h"

using namespace oracle;

namespace {

void light(GLenum which, GLfloat x, GLfloat y, GLfloat z, GLfloat w, GLfloat r, GLfloat g, GLfloat b)
{
    const GLfloat position[] = {x, y, z, w}, color[] = {r, g, b, 1},
                  ambient[] = {0.1f * r, 0.1f * g, 0.1f * b, 1};
    glLightfv(which, GL_POSITION, position);
    glLightfv(which, GL_AMBIENT, ambient);
    glLightfv(which, GL_DIFFUSE, color);
    glLightfv(which, GL_SPECULAR, color);
    glEnable(which);
}

void material(GLenum face, GLfloat r, GLfloat g, GLfloat b, GLfloat shininess)
{
    const GLfloat color[] = {r, g, b, 1}, specular[] = {0.8f, 0.8f, 0.7f, 1};
    glMaterialfv(face, GL_AMBIENT_AND_DIFFUSE, color);
    glMaterialfv(face, GL_SPECULAR, specular);
    glMaterialf(face, GL_SHININESS, shininess);
}

void lit()
{
    three_dimensions();
    glEnable(GL_LIGHTING);
    material(GL_FRONT_AND_BACK, 0.8f, 0.5f, 0.3f, 30);
}

void tilted_torus()
{
    glPushMatrix();
    glRotatef(40, 1, 0.2f, 0);
    torus(1.3f, 0.5f, 12, 24);
    glPopMatrix();
}

} // namespace

SCENE(light_directional)
{
    lit();
    light(GL_LIGHT0, 1, 2, 3, 0, 1, 1, 0.9f);
    tilted_torus();
}

SCENE(light_directional_scaled_normalized)
{
    lit();
    glEnable(GL_NORMALIZE);
    light(GL_LIGHT1, -1, 2, 1, 0, 0.9f, 0.9f, 1);
    glScalef(1.4f, 0.6f, 1);
    tilted_torus();
}

SCENE(light_scaled_rescaled)
{
    lit();
    glEnable(GL_RESCALE_NORMAL);
    light(GL_LIGHT1, -1, 2, 1, 0, 0.9f, 0.9f, 1);
    glScalef(0.7f, 0.7f, 0.7f);
    tilted_torus();
}

SCENE(light_scaled_not_normalized)
{
    lit();
    light(GL_LIGHT1, -1, 2, 1, 0, 0.4f, 0.4f, 0.5f);
    glScalef(0.8f, 0.8f, 0.8f);
    tilted_torus();
}

SCENE(light_positional)
{
    lit();
    light(GL_LIGHT0, 1, 1.5f, 2, 1, 1, 1, 0.9f);
    light(GL_LIGHT3, -2, -1, 1, 2, 0.2f, 0.3f, 0.9f);
    tilted_torus();
}

SCENE(light_attenuated)
{
    lit();
    light(GL_LIGHT0, 1, 1.5f, 2, 1, 1, 1, 0.9f);
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.3f);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2f);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1f);
    tilted_torus();
}

SCENE(light_spot)
{
    lit();
    light(GL_LIGHT0, 0, 2, 3, 1, 1, 1, 0.9f);
    const GLfloat direction[] = {0.1f, -0.6f, -1};
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 8);
    tilted_torus();
}

SCENE(light_eight)
{
    lit();
    for (int i = 0; i < 8; ++i) {
        light(GL_LIGHT0 + static_cast<GLenum>(i), static_cast<GLfloat>(i) - 3.5f, 2, 2, i % 2 ? 1.0f : 0.0f,
              0.1f * static_cast<GLfloat>(i), 0.3f, 0.5f - 0.05f * static_cast<GLfloat>(i));
    }
    tilted_torus();
}

SCENE(light_local_viewer)
{
    lit();
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    light(GL_LIGHT0, 1, 2, 3, 0, 1, 1, 0.9f);
    tilted_torus();
}

SCENE(light_two_sided)
{
    lit();
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    material(GL_BACK, 0.2f, 0.8f, 0.4f, 10);
    light(GL_LIGHT0, 1, 2, 3, 0, 1, 1, 0.9f);
    glTranslatef(0, 0, 2);
    glRotatef(70, 1, 0, 0);
    glFrontFace(GL_CW);
    torus(1.6f, 0.5f, 12, 24);
}

SCENE(light_separate_specular)
{
    lit();
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    light(GL_LIGHT0, 1, 2, 3, 0, 1, 1, 0.9f);
    tilted_torus();
}

SCENE(light_flat)
{
    lit();
    glShadeModel(GL_FLAT);
    light(GL_LIGHT0, 1, 2, 3, 0, 1, 1, 0.9f);
    tilted_torus();
}

SCENE(light_ambient_only)
{
    lit();
    const GLfloat ambient[] = {0.5f, 0.4f, 0.9f, 1}, emission[] = {0.1f, 0.2f, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT, GL_EMISSION, emission);
    tilted_torus();
}

SCENE(color_material_modes)
{
    lit();
    light(GL_LIGHT0, 1, 2, 3, 0, 1, 1, 0.9f);
    const GLenum modes[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
    glEnable(GL_COLOR_MATERIAL);
    for (int i = 0; i < 5; ++i) {
        glColorMaterial(GL_FRONT, modes[i]);
        glPushMatrix();
        glTranslatef(static_cast<GLfloat>(i) - 2, 0, 0);
        glRotatef(30, 1, 1, 0);
        glScalef(0.4f, 0.4f, 0.4f);
        glColor3f(0.2f, 0.9f, 0.4f);
        cube();
        glPopMatrix();
        // No glColor between here and the next mode: Mesa 22.3 would lose it for the property it was for.
    }
    glDisable(GL_COLOR_MATERIAL);
    glTranslatef(0, -1.2f, 0);
    torus(0.6f, 0.3f, 8, 16);
}

SCENE(color_material_per_vertex)
{
    lit();
    light(GL_LIGHT0, 1, 2, 3, 1, 1, 1, 0.9f);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glNormal3f(0, 0, 1);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 8; ++i) {
        glColor3f(static_cast<GLfloat>(i) / 8, 1 - static_cast<GLfloat>(i) / 8, 0.5f);
        glVertex3f(0.5f * static_cast<GLfloat>(i) - 2, i % 2 ? 1.0f : -1.0f, 0);
    }
    glEnd();
}

SCENE(light_positions_follow_the_modelview)
{
    lit();
    glPushMatrix();
    glRotatef(120, 0, 1, 0);
    glTranslatef(0, 1, 2);
    light(GL_LIGHT0, 0, 0, 0, 1, 1, 1, 0.9f);
    glPopMatrix();
    tilted_torus();
}
