#pragma once

#include "legacygl/vertex/primitives.h"

#include <GL/gl.h>

#include <cstdint>

namespace legacygl {

/// A triangle of a decomposed primitive: its vertices, and which of its edges (bit i: from its i-th vertex
/// on) are edges of the primitive.
struct DecomposedTriangle
{
    std::uint32_t vertices[3];
    std::uint32_t edges;
    bool begins_polygon; ///< The line stipple restarts.
};

/// Cuts a primitive of count vertices into points, lines and triangles, calling point(i), line(i, j, begins)
/// and triangle(DecomposedTriangle).
///
/// Follows the order of Mesa's pipeline, which differs from that of append_indices(): which triangle comes
/// first is seen in line stipples and blended edges. first_vertex: the first vertex of a line or triangle
/// provokes, else its last.
template <class Point, class Line, class Triangle>
void decompose(GLenum mode, std::uint32_t count, bool first_vertex, QuadOrder quad_order, Point point,
               Line line, Triangle triangle)
{
    constexpr std::uint32_t E0 = 1, E1 = 2, E2 = 4, ALL = 7;
    switch (mode) {
    case GL_POINTS:
        for (std::uint32_t i = 0; i < count; ++i) {
            point(i);
        }
        break;
    case GL_LINES:
        for (std::uint32_t i = 0; i + 1 < count; i += 2) {
            line(i, i + 1, true);
        }
        break;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP:
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            line(i, i + 1, i == 0);
        }
        if (mode == GL_LINE_LOOP && count > 1) {
            line(count - 1, 0u, false);
        }
        break;
    case GL_TRIANGLES:
        for (std::uint32_t i = 0; i + 2 < count; i += 3) {
            triangle(DecomposedTriangle{{i, i + 1, i + 2}, ALL, true});
        }
        break;
    case GL_TRIANGLE_STRIP:
        for (std::uint32_t i = 0; i + 2 < count; ++i) {
            if (i % 2 == 0) {
                triangle(DecomposedTriangle{{i, i + 1, i + 2}, ALL, true});
            } else if (first_vertex) {
                triangle(DecomposedTriangle{{i, i + 2, i + 1}, ALL, true});
            } else {
                triangle(DecomposedTriangle{{i + 1, i, i + 2}, ALL, true});
            }
        }
        break;
    case GL_TRIANGLE_FAN:
        for (std::uint32_t i = 1; i + 1 < count; ++i) {
            if (first_vertex) {
                triangle(DecomposedTriangle{{i, i + 1, 0}, ALL, true});
            } else {
                triangle(DecomposedTriangle{{0, i, i + 1}, ALL, true});
            }
        }
        break;
    case GL_QUADS:
        for (std::uint32_t i = 0; i + 3 < count; i += 4) {
            if (first_vertex && quad_order.emitted) {
                triangle(DecomposedTriangle{{i + 3, i, i + 1}, E0 | E1, true});
                triangle(DecomposedTriangle{{i + 3, i + 1, i + 2}, E1 | E2, false});
            } else if (first_vertex || quad_order.from_first) {
                triangle(DecomposedTriangle{{i, i + 1, i + 2}, E0 | E1, true});
                triangle(DecomposedTriangle{{i, i + 2, i + 3}, E1 | E2, false});
            } else {
                triangle(DecomposedTriangle{{i, i + 1, i + 3}, E0 | E2, true});
                triangle(DecomposedTriangle{{i + 1, i + 2, i + 3}, E0 | E1, false});
            }
        }
        break;
    case GL_QUAD_STRIP:
        for (std::uint32_t i = 0; i + 3 < count; i += 2) {
            if (first_vertex && quad_order.emitted) {
                triangle(DecomposedTriangle{{i + 3, i, i + 1}, E0 | E1, true});
                triangle(DecomposedTriangle{{i + 3, i + 2, i}, E1 | E2, false});
            } else if (first_vertex) {
                triangle(DecomposedTriangle{{i, i + 3, i + 2}, E0 | E1, true});
                triangle(DecomposedTriangle{{i, i + 1, i + 3}, E1 | E2, false});
            } else if (quad_order.emitted) {
                triangle(DecomposedTriangle{{i, i + 1, i + 3}, E0 | E1, true});
                triangle(DecomposedTriangle{{i + 2, i, i + 3}, E0 | E2, false});
            } else {
                triangle(DecomposedTriangle{{i + 2, i, i + 3}, E0 | E2, true});
                triangle(DecomposedTriangle{{i, i + 1, i + 3}, E0 | E1, false});
            }
        }
        break;
    case GL_POLYGON:
        for (std::uint32_t i = 0; i + 2 < count; ++i) {
            const bool first = i == 0, last = i + 3 == count;
            if (first_vertex) {
                triangle(
                    DecomposedTriangle{{0, i + 1, i + 2}, E1 | (first ? E0 : 0) | (last ? E2 : 0), first});
            } else {
                triangle(
                    DecomposedTriangle{{i + 1, i + 2, 0}, E0 | (first ? E2 : 0) | (last ? E1 : 0), first});
            }
        }
        break;
    default:
        break;
    }
}

} // namespace legacygl
