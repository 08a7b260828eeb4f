#pragma once

#include "legacygl/vertex/assembler.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// What ES can draw of OpenGL's ten primitives.
enum class PrimitiveClass : std::uint8_t
{
    points,
    lines,
    triangles
};

/// Returns what the primitive is cut into. mode is one of GL_POINTS … GL_POLYGON.
PrimitiveClass class_of(GLenum mode);

/// The two triangles that quads become, and which of them comes first.
///
/// OpenGL leaves both open (OpenGL 1.5, 2.6.1), but they are seen where a quad's corners have different
/// colours and where its triangles overlap.
struct QuadOrder
{
    bool from_first = false; ///< Separate quads are cut from their first corner, else between the others.
    bool emitted = true;     ///< Mesa hands quads to its rasteriser whole, else its pipeline cuts them.
};

/// Knows in which order the quads of each primitive of a batch are cut.
class QuadOrders
{
public:
    /// Returns the order of primitive i; the default for all but quads and quad strips.
    virtual QuadOrder of(std::size_t i) = 0;

protected:
    ~QuadOrders() = default;
};

/// Appends the primitive's points, lines or triangles as indices; incomplete ones are dropped.
///
/// The last index of each is the provoking vertex that OpenGL 1.5, table 2.12, names (the first vertex of
/// a polygon, the last of all others), since ES takes a flat colour from the last. Quads cut
/// from their first corner have it as that of their second triangle only.
void append_indices(GLenum mode, std::uint32_t first, std::uint32_t count, std::vector<std::uint32_t>& out,
                    QuadOrder quad_order = {});

/// A stretch of a batch that one draw call can draw.
struct DrawRun
{
    PrimitiveClass primitive;
    bool indexed;
    std::uint32_t first; ///< First index, or first vertex when not indexed.
    std::uint32_t count; ///< Indices, or vertices when not indexed.
};

/// Cuts primitives into as few runs as keep their order. Indices are appended where they are needed:
/// whole points, lines and triangles that follow each other are drawn without. quad_orders: null for
/// a list, whose quads are cut before it is known where they will be.
void make_runs(std::span<const Primitive> primitives, std::vector<DrawRun>& runs,
               std::vector<std::uint32_t>& indices, QuadOrders* quad_orders = nullptr);

} // namespace legacygl
