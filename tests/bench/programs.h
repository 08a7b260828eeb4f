#pragma once

/// What scripts/bench measures of OpenGL: two plain OpenGL 1.x programs, the same source for each library
/// below them. Both draw into a current context of SIZE × SIZE pixels.
namespace bench {

constexpr int SIZE = 256;

/// A program: setup once, then any number of frames, which differ by a number.
struct Program
{
    void (*setup)();
    void (*frame)(int number);
};

/// 200 objects of 64 triangles between glBegin and glEnd, lit and textured, with a normal and texture
/// coordinates a vertex and push, translate, rotate, pop around each.
extern const Program immediate;

/// 1,000 display lists, each a coloured cube of 12 triangles, called with a matrix each.
extern const Program lists;

/// The list program's numbers, which the hand-written WebGL 2 reads, too.
constexpr int LIST_COUNT = 1000;
constexpr int LIST_VERTICES = 36;
/// Position and colour of a vertex of a list, three floats each.
constexpr int LIST_FLOATS = 6;
/// Returns the vertices of a list's cube: LIST_VERTICES × LIST_FLOATS numbers, valid until the next call.
const float* list_vertices(int list);
/// Returns the LIST_COUNT matrices of 16 numbers that the lists are called with.
const float* list_matrices();

/// The triangles of the long list.
constexpr int LONG_TRIANGLES = 100000;
/// Position, normal and texture coordinates of a vertex of the long list: 3, 3 and 2 floats.
constexpr int LONG_FLOATS = 8;
/// Returns the long list's data: LONG_TRIANGLES × 3 × LONG_FLOATS numbers.
const float* long_list_vertices();
/// Gives the long list's vertices to OpenGL, between glBegin and glEnd.
void long_list();

} // namespace bench
