#pragma once

#include "legacygl/vertex_assembler.h"

#include <GL/gl.h>

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

class QuadCut;

/// What ES can draw of OpenGL's ten primitives.
enum class PrimitiveClass : std::uint8_t
{
    points,
    lines,
    triangles
};

/// Returns what the primitive is cut into. mode is one of GL_POINTS … GL_POLYGON.
PrimitiveClass class_of(GLenum mode);

/// Appends the primitive's points, lines or triangles as indices; incomplete ones are dropped.
///
/// The last index of each is the provoking vertex that OpenGL 1.5, table 2.12, names (the first vertex of
/// a polygon, the last of all others), since ES takes a flat colour from the last. Quads are cut along
/// the diagonal that Mesa uses in display lists, or from their first corner, see QuadCut; the provoking
/// vertex then is that of the second triangle only.
void append_indices(GLenum mode, std::uint32_t first, std::uint32_t count, std::vector<std::uint32_t>& out,
                    bool quads_from_first = false);

/// A stretch of a batch that one draw call can draw.
struct DrawRun
{
    PrimitiveClass primitive;
    bool indexed;
    std::uint32_t first; ///< First index, or first vertex when not indexed.
    std::uint32_t count; ///< Indices, or vertices when not indexed.
};

/// Cuts primitives into as few runs as keep their order. Indices are appended where they are needed:
/// whole points, lines and triangles that follow each other are drawn without. quad_cut: null where quads
/// are cut as in lists.
void make_runs(std::span<const Primitive> primitives, std::vector<DrawRun>& runs,
               std::vector<std::uint32_t>& indices, QuadCut* quad_cut = nullptr);

} // namespace legacygl
