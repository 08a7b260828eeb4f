// Display lists (OpenGL 1.5, 5.4), first of all the handout's own example.

#include "scenes/common.h"

using namespace oracle;

SCENE(handout_floor_cube_and_ball)
{
    three_dimensions();
    const GLuint first = glGenLists(3);
    glNewList(first, GL_COMPILE);
    glColor3f(0.4f, 0.4f, 0.4f);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glVertex3f(i % 2 ? 3.0f : -3.0f, -1, i / 2 ? -3.0f : 3.0f);
    }
    glEnd();
    glEndList();
    glNewList(first + 1, GL_COMPILE);
    cube();
    glEndList();
    glNewList(first + 2, GL_COMPILE);
    glColor3f(0.9f, 0.2f, 0.2f);
    torus(0.4f, 0.3f, 10, 16);
    glEndList();

    glCallList(first);
    glPushMatrix();
    glTranslatef(-1, 0, 0);
    glRotatef(30, 0, 1, 0);
    glScalef(0.6f, 0.6f, 0.6f);
    glCallList(first + 1);
    glPopMatrix();
    glPushMatrix();
    glTranslatef(1.2f, 0, 0);
    glRotatef(60, 1, 0, 0);
    glCallList(first + 2);
    glPopMatrix();
}

SCENE(list_uses_the_current_colour_of_the_call,
      {1740,
       "OpenGL 1.5, 2.7: a vertex has the colour that is current when it is given, and 5.4: a list's "
       "commands are "
       "executed at the call. This Mesa gives those before the list's first colour that colour.",
       {23}})
{
    two_dimensions();
    const GLuint list = glGenLists(1);
    glColor3f(1, 0, 0);
    glNewList(list, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    glVertex2f(0, 0);
    glVertex2f(3, 0);
    glColor3f(0, 0, 1); // Only from the third vertex on.
    glVertex2f(0, 3);
    glEnd();
    glEndList();
    const float colors[4][3] = {{0, 1, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}};
    for (const float* color : colors) {
        glColor3fv(color);
        glCallList(list);
        glTranslatef(4, 2, 0);
    }
    GLfloat left[4];
    glGetFloatv(GL_CURRENT_COLOR, left);
    tell(std::to_string(left[0]) + " " + std::to_string(left[1]) + " " + std::to_string(left[2]));
}

SCENE(list_continues_and_closes_a_primitive)
{
    two_dimensions();
    const GLuint first = glGenLists(3);
    glNewList(first, GL_COMPILE);
    glBegin(GL_TRIANGLE_STRIP);
    glColor3f(1, 0, 0);
    glVertex2f(1, 1);
    glVertex2f(3, 10);
    glEndList();
    glNewList(first + 1, GL_COMPILE);
    glColor3f(0, 1, 0);
    glVertex2f(6, 2);
    glVertex2f(9, 11);
    glEndList();
    glNewList(first + 2, GL_COMPILE);
    glVertex2f(12, 3);
    glEnd();
    glEndList();
    glCallList(first);
    glCallList(first + 1);
    glColor3f(0, 0, 1);
    glCallList(first + 2);
    glCallList(first + 2); // An End too many.
}

SCENE(list_binds_children_at_call_time)
{
    two_dimensions();
    const GLuint first = glGenLists(2);
    glNewList(first, GL_COMPILE);
    glCallList(first + 1);
    glTranslatef(5, 0, 0);
    glEndList();
    const auto define = [first](float r, float g, float b) {
        glNewList(first + 1, GL_COMPILE);
        glColor3f(r, g, b);
        glBegin(GL_TRIANGLES);
        glVertex2f(1, 1);
        glVertex2f(4, 1);
        glVertex2f(1, 9);
        glEnd();
        glEndList();
    };
    glCallList(first); // The child is still empty.
    define(1, 0.5f, 0);
    glCallList(first);
    define(0, 0.5f, 1);
    glCallList(first);
    glDeleteLists(first + 1, 1);
    glCallList(first);
    tell(std::to_string(glIsList(first)) + std::to_string(glIsList(first + 1)) + std::to_string(glIsList(0)));
}

SCENE(list_compile_and_execute)
{
    two_dimensions();
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE_AND_EXECUTE);
    glColor3f(0.2f, 0.9f, 0.9f);
    glBegin(GL_TRIANGLE_FAN);
    glVertex2f(1, 1);
    glVertex2f(4, 1);
    glVertex2f(4, 5);
    glVertex2f(1, 5);
    glEnd();
    glTranslatef(5, 3, 0);
    glEndList();
    glCallList(list);
}

SCENE(list_of_state_matrices_and_materials)
{
    three_dimensions();
    const GLuint list = glGenLists(1);
    GLfloat color[] = {0.9f, 0.3f, 0.3f, 1}, position[] = {1, 2, 3, 0};
    GLdouble matrix[16] = {0.5, 0, 0, 0, 0, 0.7, 0, 0, 0, 0, 0.5, 0, 0.5, 0.2, 0, 1};
    glNewList(list, GL_COMPILE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
    glPushMatrix();
    glMultMatrixd(matrix);
    torus(1, 0.5f, 8, 12);
    glPopMatrix();
    glDisable(GL_LIGHTING);
    glEndList();
    for (int i = 0; i < 4; ++i) { // What pointers point to was copied.
        color[i] = position[i] = 0;
    }
    for (double& m : matrix) {
        m = 0;
    }
    glCallList(list);
    glTranslatef(-1.5f, 0, 0);
    glCallList(list);
}

SCENE(lists_and_their_errors)
{
    two_dimensions();
    const auto error = [](const char* what) {
        tell(std::string(what) + " " + std::to_string(oracle::next_error()));
    };
    glNewList(0, GL_COMPILE);
    error("name 0");
    glNewList(1, GL_LINES);
    error("mode");
    glEndList();
    error("end without new");
    glNewList(5, GL_COMPILE);
    glNewList(6, GL_COMPILE);
    error("nested");
    glPopMatrix();
    glEnable(0x1234);
    error("compiled errors wait");
    glEndList();
    glCallList(5);
    error("pop at call");
    glCallList(77);
    error("unknown list");
    glDeleteLists(5, -1);
    error("negative range");
    tell(std::to_string(glGenLists(0)));
    error("none");
    glGenLists(-1);
    error("fewer");
    const GLuint block = glGenLists(3);
    glDeleteLists(block + 1, 1);
    tell(std::to_string(glIsList(block)) + std::to_string(glIsList(block + 1)) +
         std::to_string(glIsList(block + 2)));
}

SCENE(list_deletes_itself_while_it_runs)
{
    two_dimensions();
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glColor3f(1, 1, 0);
    glBegin(GL_TRIANGLES);
    glVertex2f(1, 1);
    glVertex2f(9, 1);
    glVertex2f(1, 9);
    glEnd();
    glCallList(list); // Recursion ends at the nesting limit.
    glEndList();
    glCallList(list);
    glDeleteLists(list, 1);
    glTranslatef(6, 0, 0);
    glCallList(list);
}

SCENE(call_lists_with_every_type)
{
    two_dimensions();
    const GLuint base = glGenLists(300);
    for (GLuint i = 0; i < 300; ++i) {
        glNewList(base + i, GL_COMPILE);
        glColor3f(static_cast<float>(i % 7) / 7, static_cast<float>(i % 5) / 5, 1);
        glBegin(GL_TRIANGLES);
        glVertex2f(0, 0);
        glVertex2f(1, 0);
        glVertex2f(0, 1 + static_cast<float>(i % 3));
        glEnd();
        glTranslatef(1.1f, 0, 0);
        glEndList();
    }
    glListBase(base);
    const GLbyte bytes[] = {0, 5, 100};
    glCallLists(3, GL_BYTE, bytes);
    glListBase(base + 200);
    const GLint ints[] = {-200, 99, -1};
    glCallLists(3, GL_INT, ints);
    const GLshort shorts[] = {-7, 12};
    glCallLists(2, GL_SHORT, shorts);
    const GLfloat floats[] = {3.7f, 40.2f};
    glCallLists(2, GL_FLOAT, floats);
    glLoadIdentity();
    glTranslatef(0, 5, 0);
    glListBase(base);
    const GLubyte pairs[] = {1, 20, 0, 3};
    glCallLists(2, GL_2_BYTES, pairs);
    const GLubyte triples[] = {0, 1, 2};
    glCallLists(1, GL_3_BYTES, triples);
    const GLubyte quadruples[] = {0, 0, 0, 77};
    glCallLists(1, GL_4_BYTES, quadruples);
    glNewList(base, GL_COMPILE);
    glCallLists(3, GL_UNSIGNED_BYTE, "\x05\x06\x07");
    glEndList();
    glCallList(base);
    GLint answer = 0;
    glGetIntegerv(GL_LIST_BASE, &answer);
    tell(std::to_string(answer - static_cast<GLint>(base)));
    glCallLists(1, GL_DOUBLE, floats);
    tell(std::to_string(oracle::next_error()));
    glCallLists(-1, GL_BYTE, bytes);
    tell(std::to_string(oracle::next_error()));
}

SCENE(rectangles)
{
    two_dimensions();
    glColor3f(0.8f, 0.3f, 0.3f);
    glRecti(1, 1, 5, 4);
    glColor3f(0.3f, 0.8f, 0.3f);
    glRectf(6.5f, 1.2f, 9.1f, 8.8f);
    const GLdouble one[] = {14, 10}, other[] = {10.5, 2};
    glEnable(GL_CULL_FACE); // Both corners changed: still counter-clockwise.
    glRectdv(one, other);
    glRects(2, 10, 5, 6); // One pair changed: clockwise, and culled.
}
