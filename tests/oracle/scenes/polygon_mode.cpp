// Polygons drawn as points and lines (OpenGL 1.5, 3.5.4), with edge flags, faces, offsets and shading.

#include "scenes/common.h"

using namespace oracle;

namespace {

/// Lights from above the eye's right shoulder.
void light()
{
    const GLfloat position[4] = {1, 2, 3, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
}

/// A seven-sided polygon and the other polygons, each corner in its own colour.
void polygons(bool edge_flags)
{
    const GLenum modes[] = {GL_POLYGON,        GL_TRIANGLES,    GL_QUADS,
                            GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUAD_STRIP};
    const int counts[] = {7, 6, 8, 6, 6, 6};
    for (int cell = 0; cell < 6; ++cell) {
        const float x = 5.0f * static_cast<float>(cell % 3) + 0.6f,
                    y = 6.0f * static_cast<float>(cell / 3) + 0.6f;
        constexpr float ring[8][2] = {{2, 0.2f},    {3.6f, 0.9f}, {4.1f, 2.4f}, {3.2f, 4.1f},
                                      {1.6f, 4.3f}, {0.4f, 3.3f}, {0.2f, 1.6f}, {0.9f, 0.5f}};
        glBegin(modes[cell]);
        for (int i = 0; i < counts[cell]; ++i) {
            const bool zigzag = modes[cell] == GL_TRIANGLE_STRIP || modes[cell] == GL_QUAD_STRIP;
            if (edge_flags) {
                glEdgeFlag(i % 3 != 1);
            }
            glColor3f(static_cast<float>(i % 2), static_cast<float>(i % 3) * 0.5f,
                      1 - static_cast<float>(i % 4) * 0.3f);
            if (zigzag) {
                glVertex2f(x + 0.7f * static_cast<float>(i), y + (i % 2 == 0 ? 0.3f : 4.0f));
            } else {
                glVertex2f(x + ring[i][0], y + ring[i][1]);
            }
        }
        glEnd();
    }
    glEdgeFlag(GL_TRUE);
}

} // namespace

SCENE(polygon_mode_line_of_every_polygon)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    polygons(false);
}

SCENE(polygon_mode_point_of_every_polygon)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(4);
    polygons(false);
}

SCENE(polygon_mode_line_flat)
{
    two_dimensions();
    glShadeModel(GL_FLAT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    polygons(false);
}

SCENE(polygon_mode_line_with_edge_flags)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    polygons(true);
}

SCENE(polygon_mode_point_with_edge_flags)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(5);
    polygons(true);
}

SCENE(polygon_mode_all_edges_off)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRectf(1, 1, 5, 5);
    glEdgeFlag(GL_FALSE);
    glRectf(6, 1, 10, 5);
    polygons(false);
    glEdgeFlag(GL_TRUE);
    glRectf(11, 1, 15, 5);
}

SCENE(polygon_mode_wide_lines)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(3);
    polygons(false);
}

SCENE(polygon_mode_lit_torus)
{
    three_dimensions();
    light();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRotatef(30, 1, 0, 0);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(polygon_mode_lit_flat_torus)
{
    three_dimensions();
    light();
    glShadeModel(GL_FLAT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRotatef(60, 1, 0, 0);
    torus(1.2f, 0.5f, 8, 11);
}

SCENE(polygon_mode_lit_shiny_points)
{
    three_dimensions();
    light();
    const GLfloat white[4] = {1, 1, 1, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(3);
    glRotatef(40, 1, 0, 0);
    torus(1.2f, 0.5f, 16, 24);
}

SCENE(polygon_mode_of_each_face)
{
    three_dimensions();
    glPolygonMode(GL_FRONT, GL_FILL);
    glPolygonMode(GL_BACK, GL_LINE);
    glTranslatef(-1, 0, 0);
    glRotatef(40, 1, 1, 0);
    glBegin(GL_QUADS);
    glColor3f(1, 0.5f, 0);
    glVertex3f(-1, -1, 0.5f);
    glVertex3f(1, -1, 0.5f);
    glVertex3f(1, 1, 0.5f);
    glVertex3f(-1, 1, 0.5f);
    glColor3f(0, 0.8f, 1);
    glVertex3f(1.4f, -1, 0.2f);
    glVertex3f(1.4f, 1, 0.2f);
    glVertex3f(3, 1, 0.2f);
    glVertex3f(3, -1, 0.2f);
    glEnd();
}

SCENE(polygon_mode_front_lines_back_points_clockwise)
{
    three_dimensions();
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    glPointSize(5);
    glRotatef(25, 1, 0.5f, 0);
    cube();
}

SCENE(polygon_mode_line_with_culled_back_faces)
{
    three_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_CULL_FACE);
    glRotatef(25, 1, 0.5f, 0);
    cube();
}

SCENE(polygon_mode_line_with_culled_front_faces)
{
    three_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glRotatef(25, 1, 0.5f, 0);
    cube();
}

SCENE(polygon_mode_culls_the_face_that_is_not_filled)
{
    three_dimensions();
    glPolygonMode(GL_BACK, GL_LINE);
    glEnable(GL_CULL_FACE);
    glRotatef(25, 1, 0.5f, 0);
    cube();
}

// A triangle without an area is no face that is culled by mistake: it is drawn as the other face is.
SCENE(polygon_mode_of_flat_triangles_with_culled_faces)
{
    two_dimensions();
    glEnable(GL_CULL_FACE);
    const GLenum culled[] = {GL_FRONT, GL_BACK};
    const GLenum unfilled[] = {GL_LINE, GL_POINT};
    for (int i = 0; i < 8; ++i) {
        glCullFace(culled[i & 1]);
        glFrontFace(i & 2 ? GL_CW : GL_CCW);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        glPolygonMode(i & 1 ? GL_FRONT : GL_BACK, unfilled[i / 4]);
        const float y = 1 + 1.3f * static_cast<float>(i);
        glBegin(GL_TRIANGLE_STRIP);
        glVertex2f(1, y);
        glVertex2f(6, y + 1);
        glVertex2f(1, y);
        glVertex2f(11, y);
        glVertex2f(15, y + 1);
        glVertex2f(15, y + 1);
        glEnd();
    }
}

SCENE(polygon_mode_lights_two_sides)
{
    three_dimensions();
    light();
    glDisable(GL_COLOR_MATERIAL);
    const GLfloat red[4] = {1, 0.1f, 0.1f, 1}, green[4] = {0.1f, 1, 0.2f, 1};
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, red);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, green);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRotatef(70, 1, 0.2f, 0);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(hidden_lines_by_polygon_offset)
{
    three_dimensions();
    glRotatef(40, 1, 0.3f, 0);
    glColor3f(1, 1, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3f(1, 1, 0.3f);
    torus(1.2f, 0.5f, 9, 14);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
    glDisable(GL_COLOR_MATERIAL);
    glColor3f(0.1f, 0.3f, 0.2f);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(hidden_lines_by_offset_lines)
{
    three_dimensions();
    glRotatef(40, 1, 0.3f, 0);
    glColor3f(0.1f, 0.3f, 0.5f);
    torus(1.2f, 0.5f, 9, 14);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_POLYGON_OFFSET_LINE);
    glPolygonOffset(-1, -1);
    glColor3f(1, 1, 1);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(offset_points_over_a_surface)
{
    three_dimensions();
    glRotatef(40, 1, 0.3f, 0);
    glColor3f(0.1f, 0.3f, 0.5f);
    torus(1.2f, 0.5f, 9, 14);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glEnable(GL_POLYGON_OFFSET_POINT);
    glPolygonOffset(-1.5f, -4);
    glPointSize(3);
    glColor3f(1, 1, 1);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(polygon_mode_cut_by_the_view_volume)
{
    three_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glTranslatef(0.5f, 0.4f, 3);
    glRotatef(20, 1, 1, 0);
    cube();
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(4);
    glTranslatef(-1.2f, 0, 0);
    cube();
}

SCENE(polygon_mode_stippled)
{
    two_dimensions();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x0f3f);
    polygons(false);
}

SCENE(polygon_mode_fogged_and_textured)
{
    three_dimensions();
    const GLubyte texels[4 * 4] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 3);
    glFogf(GL_FOG_END, 7);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRotatef(50, 1, 0.4f, 0);
    torus(1.2f, 0.5f, 9, 14);
}

SCENE(polygon_mode_from_a_list)
{
    three_dimensions();
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glPolygonMode(GL_FRONT, GL_LINE);
    glRotatef(50, 1, 0.4f, 0);
    cube();
    glEndList();
    glCallList(list);
    glTranslatef(0.7f, 0, 0);
    glCallList(list);
}

SCENE(wireframe_solar_system)
{
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, static_cast<double>(WIDTH) / HEIGHT, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);
    GLUquadric* quadric = gluNewQuadric();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3f(1, 1, 1);
    gluSphere(quadric, 1, 20, 16);
    glRotatef(30, 0, 1, 0);
    glTranslatef(2, 0, 0);
    glRotatef(15, 0, 1, 0);
    gluSphere(quadric, 0.2, 10, 8);
    gluDeleteQuadric(quadric);
}
