#include "programs.h"

#include <GL/gl.h>

#include <array>

namespace bench {
namespace {

GLuint first_list = 0;

void setup()
{
    glViewport(0, 0, SIZE, SIZE);
    glClearColor(0.1f, 0.1f, 0.2f, 1);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 2, 60);
    glMatrixMode(GL_MODELVIEW);
    first_list = glGenLists(LIST_COUNT);
    for (int i = 0; i < LIST_COUNT; ++i) {
        const float* vertices = list_vertices(i);
        glNewList(first_list + i, GL_COMPILE);
        glBegin(GL_TRIANGLES);
        for (int v = 0; v < LIST_VERTICES; ++v) {
            glColor3fv(vertices + LIST_FLOATS * v + 3);
            glVertex3fv(vertices + LIST_FLOATS * v);
        }
        glEnd();
        glEndList();
    }
}

void frame(int number)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0, 0, -30);
    glRotatef(static_cast<float>(number), 0, 1, 0);
    const float* matrices = list_matrices();
    for (int i = 0; i < LIST_COUNT; ++i) {
        glPushMatrix();
        glMultMatrixf(matrices + 16 * i);
        glCallList(first_list + i);
        glPopMatrix();
    }
}

} // namespace

const float* list_vertices(int list)
{
    static std::array<float, LIST_VERTICES * LIST_FLOATS> vertices;
    float* out = vertices.data();
    for (int side = 0; side < 6; ++side) {
        for (const auto& [s, t] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
            const int axis = side / 2, sign = side % 2;
            float place[3];
            place[axis] = sign - 0.5f;
            place[(axis + 1) % 3] = s - 0.5f;
            place[(axis + 2) % 3] = t - 0.5f;
            for (const float coordinate : place) {
                *out++ = 0.7f * coordinate;
            }
            for (int channel = 0; channel < 3; ++channel) {
                *out++ = static_cast<float>((list * 37 + side * 5 + channel * 11 + s + 2 * t) % 17) / 16.0f;
            }
        }
    }
    return vertices.data();
}

const float* list_matrices()
{
    static const std::array<float, 16 * LIST_COUNT> matrices = [] {
        std::array<float, 16 * LIST_COUNT> made{};
        for (int i = 0; i < LIST_COUNT; ++i) {
            float* m = made.data() + 16 * i;
            m[0] = m[5] = m[10] = m[15] = 1;
            for (int axis = 0, at = i; axis < 3; ++axis, at /= 10) {
                m[12 + axis] = 2.0f * static_cast<float>(at % 10) - 9.0f;
            }
        }
        return made;
    }();
    return matrices.data();
}

const Program lists = {setup, frame};

} // namespace bench
