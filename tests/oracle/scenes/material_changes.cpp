// glMaterial between glBegin and glEnd (OpenGL 1.5, 2.6.3 and 2.14.2), and which way quads are cut.

#include "scenes/common.h"

using namespace oracle;

namespace {

void light()
{
    const GLfloat position[4] = {1, 2, 3, 0}, white[4] = {1, 1, 1, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
}

void material(float r, float g, float b)
{
    const GLfloat color[4] = {r, g, b, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
}

/// A cube of one batch of quads, a material a face.
void cube_of_materials(bool per_vertex)
{
    static const float normals[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    glBegin(GL_QUADS);
    for (int face = 0; face < 6; ++face) {
        const float* n = normals[face];
        const float u[3] = {n[1], n[2], n[0]};
        const float v[3] = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};
        material(0.2f + 0.15f * static_cast<float>(face), 0.5f, 0.9f - 0.1f * static_cast<float>(face));
        glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, face % 2 == 0 ? 25.0f : 0.0f);
        glNormal3fv(n);
        for (int corner = 0; corner < 4; ++corner) {
            const float s = corner == 1 || corner == 2 ? 1.0f : -1.0f, t = corner >= 2 ? 1.0f : -1.0f;
            if (per_vertex) {
                material(static_cast<float>(corner) * 0.3f, 0.4f, static_cast<float>(face) * 0.15f);
            }
            glVertex3f(n[0] + s * u[0] + t * v[0], n[1] + s * u[1] + t * v[1], n[2] + s * u[2] + t * v[2]);
        }
    }
    glEnd();
}

/// Quads whose corners have four colours.
void checker_of_quads(float scale)
{
    glBegin(GL_QUADS);
    for (int i = 0; i < 6; ++i) {
        for (int corner = 0; corner < 4; ++corner) {
            const float x = static_cast<float>(i % 3) - 1 + (corner == 1 || corner == 2 ? 0.45f : -0.45f);
            const float y = static_cast<float>(i / 3) - 0.5f + (corner >= 2 ? 0.45f : -0.45f);
            glColor3f(corner == 0, corner == 1 || corner == 3, corner == 2);
            glVertex3f(x * scale, y * scale, 0.3f * static_cast<float>(corner));
        }
    }
    glEnd();
}

} // namespace

SCENE(material_a_face)
{
    three_dimensions();
    light();
    glRotatef(30, 1, 1, 0);
    cube_of_materials(false);
}

SCENE(material_a_vertex)
{
    three_dimensions();
    light();
    glRotatef(30, 1, 1, 0);
    cube_of_materials(true);
}

SCENE(material_a_face_flat)
{
    three_dimensions();
    light();
    glShadeModel(GL_FLAT);
    glRotatef(30, 1, 1, 0);
    cube_of_materials(true);
}

SCENE(material_a_vertex_in_a_list)
{
    three_dimensions();
    light();
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    cube_of_materials(false);
    glEndList();
    glRotatef(30, 1, 1, 0);
    glTranslatef(-1, 0, 0);
    glScalef(0.5f, 0.5f, 0.5f);
    glCallList(list);
    glTranslatef(4, 0, 0);
    glBegin(GL_TRIANGLES); // With the material that the list left.
    glNormal3f(0, 0, 1);
    glVertex3f(-1, -1, 0);
    glVertex3f(1, -1, 0);
    glVertex3f(0, 1, 0);
    glEnd();
}

SCENE(material_changes_while_the_color_drives_it)
{
    three_dimensions();
    light();
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
    glColor3f(0.2f, 0.8f, 0.3f);
    glRotatef(30, 1, 1, 0);
    cube_of_materials(false);
}

SCENE(material_of_each_side_changes)
{
    three_dimensions();
    light();
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    const GLfloat red[4] = {1, 0, 0, 1}, blue[4] = {0, 0.2f, 1, 1}, green[4] = {0, 0.7f, 0, 1};
    glBegin(GL_TRIANGLES);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
    glMaterialfv(GL_BACK, GL_DIFFUSE, blue);
    glNormal3f(0, 0, 1);
    glVertex3f(-2, -1, 0);
    glVertex3f(0, -1, 0);
    glVertex3f(-1, 1, 0);
    glMaterialfv(GL_FRONT, GL_EMISSION, green);
    glNormal3f(0, 0, -1);
    glVertex3f(0, -1, 0);
    glMaterialfv(GL_BACK, GL_DIFFUSE, green);
    glVertex3f(1, 1, 0);
    glVertex3f(2, -1, 0);
    glEnd();
}

SCENE(quads_of_four_colours)
{
    three_dimensions();
    glRotatef(20, 1, 1, 0);
    checker_of_quads(1);
}

SCENE(quads_of_four_colours_partly_outside)
{
    three_dimensions();
    glRotatef(20, 1, 1, 0);
    checker_of_quads(1.7f);
}

SCENE(quads_of_four_colours_flat)
{
    three_dimensions();
    glShadeModel(GL_FLAT);
    checker_of_quads(1);
}

SCENE(quads_of_four_colours_from_a_list)
{
    three_dimensions();
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    checker_of_quads(1);
    glEndList();
    glRotatef(20, 1, 1, 0);
    glCallList(list);
}

SCENE(quads_of_four_colours_from_arrays)
{
    three_dimensions();
    const GLfloat positions[8][2] = {{-2, -1},   {-0.2f, -1}, {-0.2f, 1}, {-2, 1},
                                     {0.2f, -1}, {2, -1},     {2, 1},     {0.2f, 1}};
    const GLfloat colors[8][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0},
                                  {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}};
    const GLubyte indices[4] = {4, 5, 6, 7};
    glVertexPointer(2, GL_FLOAT, 0, positions);
    glColorPointer(3, GL_FLOAT, 0, colors);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawArrays(GL_QUADS, 0, 4);
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_VERTEX_ARRAY);
}
