// Draws that can be gathered into one: with many transforms, with the same list again and again, and with
// attributes that the batch before had and this one does not.

#include "scenes/common.h"

using namespace oracle;

namespace {

/// A triangle whose corners have colours of their own, without alpha.
void colorful_triangle()
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0.2f, 0.1f);
    glVertex2f(0, 0);
    glColor3f(0.1f, 0.9f, 0.2f);
    glVertex2f(1, 0);
    glColor3f(0.2f, 0.3f, 1);
    glVertex2f(0, 1);
    glEnd();
}

/// Two lists of a few vertices each: a triangle, which needs no indices, and a strip, which does.
GLuint make_small_lists()
{
    const GLuint first = glGenLists(2);
    glNewList(first, GL_COMPILE);
    colorful_triangle();
    glEndList();
    glNewList(first + 1, GL_COMPILE);
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i < 6; ++i) {
        glColor3f(static_cast<float>(i) / 6, 0.5f, 1 - static_cast<float>(i) / 6);
        glVertex2f(0.2f * static_cast<float>(i / 2), static_cast<float>(i % 2));
    }
    glEnd();
    glEndList();
    return first;
}

} // namespace

SCENE(colors_with_alpha_after_colors_without)
{
    two_dimensions();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 8; ++i) {
        glPushMatrix();
        glTranslatef(static_cast<float>(i) * 1.8f + 0.5f, 1, 0);
        glScalef(3, 8, 1);
        colorful_triangle();
        if (i % 2 == 0) {
            glColor4f(1, 1, 0, 0.3f);
        }
        glBegin(GL_QUADS);
        if (i % 2 == 1) {
            glColor4f(0, 1, 1, 0.2f + 0.1f * static_cast<float>(i));
        }
        glVertex2f(0, 0.1f);
        glVertex2f(0.7f, 0.1f);
        glVertex2f(0.7f, 0.8f);
        glVertex2f(0, 0.8f);
        glEnd();
        glPopMatrix();
    }
}

SCENE(one_small_list_with_many_matrices)
{
    two_dimensions();
    const GLuint lists = make_small_lists();
    for (int i = 0; i < 150; ++i) {
        glPushMatrix();
        glTranslatef(static_cast<float>(i % 15) + 0.5f, static_cast<float>(i / 15) + 0.5f, 0);
        glRotatef(static_cast<float>(7 * i), 0, 0, 1);
        glScalef(0.9f, 0.6f, 1);
        glCallList(lists + (i / 40) % 2);
        glPopMatrix();
    }
    glDeleteLists(lists, 2);
}

SCENE(many_small_lists_in_and_out_of_order)
{
    two_dimensions();
    constexpr int COUNT = 90;
    const GLuint lists = glGenLists(COUNT);
    for (int i = 0; i < COUNT; ++i) {
        glNewList(lists + i, GL_COMPILE);
        glBegin(i % 3 == 0 ? GL_QUADS : i % 3 == 1 ? GL_TRIANGLES : GL_LINE_LOOP);
        for (int corner = 0; corner < (i % 3 == 1 ? 3 : 4); ++corner) {
            glColor3f(static_cast<float>(i) / COUNT, static_cast<float>(corner) / 4, 0.7f);
            glVertex2f(corner == 1 || corner == 2 ? 0.8f : 0.1f, corner >= 2 ? 0.8f : 0.1f);
        }
        glEnd();
        glEndList();
    }
    for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < COUNT; ++i) {
            glPushMatrix();
            glTranslatef(static_cast<float>(i % 15), static_cast<float>(i / 15 + 6 * pass), 0);
            glCallList(lists + (pass == 0 ? i : i * 37 % COUNT));
            glPopMatrix();
        }
        glDeleteLists(lists + 20, pass == 0 ? 5 : 0);
    }
    glDeleteLists(lists, COUNT);
}

SCENE(lists_and_immediate_mode_take_turns)
{
    three_dimensions();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_NORMALIZE);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    cube();
    glEndList();
    for (int i = 0; i < 24; ++i) {
        glPushMatrix();
        glRotatef(15.0f * static_cast<float>(i), 0, 1, 0);
        glTranslatef(2.5f, static_cast<float>(i % 3) - 1, 0);
        glScalef(0.3f, 0.3f, 0.3f);
        glColor3f(static_cast<float>(i % 4) / 4, 0.6f, 0.9f);
        if (i % 3 == 2) {
            cube();
        } else {
            glCallList(list);
        }
        glPopMatrix();
    }
    glDeleteLists(list, 1);
}
