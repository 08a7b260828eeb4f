// Vertex arrays and buffer objects (OpenGL 1.5, 2.8 and 2.9).

#define GL_GLEXT_PROTOTYPES
#include "scenes/common.h"

#include <cstdint>

using namespace oracle;

namespace {

const GLfloat positions[] = {1, 1, 6, 1, 1, 6, 6, 6, 11, 1, 11, 6};
const GLubyte colors[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0, 0, 255, 255, 255, 0, 255};
const GLushort indices[] = {0, 1, 2, 2, 1, 3, 1, 4, 3, 3, 4, 5};

void arrays()
{
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, positions);
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, colors);
}

} // namespace

SCENE(draw_arrays)
{
    two_dimensions();
    arrays();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 6);
    glTranslatef(4, 5, 0);
    glDrawArrays(GL_TRIANGLES, 1, 3);
    glDisableClientState(GL_COLOR_ARRAY);
    glColor3f(1, 0.5f, 0);
    glTranslatef(0, -4, 0);
    glDrawArrays(GL_LINE_LOOP, 0, 5);
}

SCENE(draw_elements_of_every_type)
{
    two_dimensions();
    arrays();
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices);
    const GLubyte bytes[] = {1, 4, 3};
    glTranslatef(3, 1, 0);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, bytes);
    const GLuint ints[] = {3, 4, 5};
    glTranslatef(1, 2, 0);
    glDrawRangeElements(GL_TRIANGLES, 3, 5, 3, GL_UNSIGNED_INT, ints);
}

SCENE(array_elements_between_begin_and_end)
{
    two_dimensions();
    arrays();
    glBegin(GL_TRIANGLES);
    for (GLushort i : indices) {
        glArrayElement(i);
    }
    glEnd();
}

SCENE(interleaved_arrays)
{
    three_dimensions();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    const GLfloat vertices[] = {1, 0.2f, 0.2f, 1, 0,    0,     1,    -1, -1, 0, //
                                0, 1,    0.2f, 1, 0,    0.6f,  0.8f, 1,  -1, 0, //
                                0, 0.2f, 1,    1, 0.6f, 0,     0.8f, -1, 1,  0, //
                                1, 1,    0.2f, 1, 0,    -0.6f, 0.8f, 1,  1,  0};
    glInterleavedArrays(GL_C4F_N3F_V3F, 0, vertices);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

SCENE(arrays_in_a_list_are_copied)
{
    two_dimensions();
    GLshort moving[] = {1, 1, 8, 1, 1, 8};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_SHORT, 0, moving);
    glNewList(1, GL_COMPILE);
    glColor3f(0.4f, 0.9f, 0.4f);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEndList();
    for (GLshort& m : moving) {
        m = 0;
    }
    glDisableClientState(GL_VERTEX_ARRAY);
    glCallList(1);
    glTranslatef(5, 2, 0);
    glCallList(1);
}

SCENE(arrays_in_buffer_objects)
{
    two_dimensions();
    GLuint names[2];
    glGenBuffers(2, names);
    glBindBuffer(GL_ARRAY_BUFFER, names[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof positions + sizeof colors, nullptr, GL_STATIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof positions, positions);
    glBufferSubData(GL_ARRAY_BUFFER, sizeof positions, sizeof colors, colors);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glColorPointer(3, GL_UNSIGNED_BYTE, 0,
                   reinterpret_cast<const void*>(static_cast<std::uintptr_t>(sizeof positions)));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
    glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(std::uintptr_t{6}));
    GLint size = 0;
    glGetBufferParameteriv(GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
    tell(std::to_string(size));
    tell(std::to_string(glIsBuffer(names[0])) + std::to_string(glIsBuffer(99)));
}

SCENE(array_errors)
{
    two_dimensions();
    const auto error = [](const char* what) {
        tell(std::string(what) + " " + std::to_string(oracle::next_error()));
    };
    glVertexPointer(5, GL_FLOAT, 0, positions);
    error("size");
    glVertexPointer(3, GL_UNSIGNED_BYTE, 0, positions);
    error("type");
    glColorPointer(3, GL_FLOAT, -1, positions);
    error("stride");
    glEnableClientState(GL_LIGHTING);
    error("array");
    glDrawArrays(99, 0, 3);
    error("mode");
    glDrawArrays(GL_TRIANGLES, 0, -3);
    error("count");
    glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, indices);
    error("index type");
    glInterleavedArrays(GL_LINES, 0, positions);
    error("format");
}
