#pragma once

#include "legacygl/cpu_pipeline/decomposition.h"
#include "legacygl/cpu_pipeline/raster_output.h"
#include "legacygl/cpu_pipeline/vertex_shading.h"

#include <array>
#include <span>

namespace legacygl {

/// Which of OpenGL's ways to rasterise are done here and not by ES.
struct RasterWork
{
    bool unfilled;   ///< Polygons are culled, offset and replaced by points or lines here.
    bool line_quads; ///< Lines are drawn as quadrilaterals, with the coverage of Mesa's.
    bool smooth_lines;
    bool smooth_points;
    bool beyond_viewport; ///< Some of the target is outside of the viewport, and lines may reach there.
};

/// Takes shaded primitives through what lies between vertices and fragments, in the order of Mesa's pipeline:
/// clip, cull, choose the face's colour, offset, shade flat, replace polygons by points and lines, stipple
/// lines, and draw wide and smooth ones as quadrilaterals (OpenGL 1.5, 2.12 to 3.5).
class PrimitivePipeline
{
public:
    /// stipple_counter lives on from one draw to the next.
    PrimitivePipeline(const State& state, const ShaderKey& key, const RasterWork& work,
                      const VertexShading& shading, std::uint32_t& stipple_counter, RasterOutput& out);

    void draw(GLenum mode, QuadOrder quad_order, std::span<const ShadedVertex> vertices);

private:
    using Triangle = std::array<ShadedVertex, 3>;

    void point(const ShadedVertex& vertex);
    void line(const ShadedVertex& a, const ShadedVertex& b, bool begins);
    void polygon(std::span<const ShadedVertex> vertices, const DecomposedTriangle& triangle);
    void whole_triangle(Triangle& whole, const ClippedPolygon& inside);
    bool choose_face(Triangle& triangle, float area) const;
    void triangle(Triangle& triangle, std::uint32_t edges, bool begins);
    void offset(Triangle& triangle, float determinant, GLenum mode) const;
    void make_flat(std::span<ShadedVertex> vertices, std::size_t provoking) const;
    void stippled_line(const ShadedVertex& a, const ShadedVertex& b);
    void draw_line(const ShadedVertex& a, const ShadedVertex& b, bool cut);
    void draw_point(const ShadedVertex& vertex);

    const State& state_;
    const ShaderKey& key_;
    const RasterWork work_;
    const VertexShading& shading_;
    const bool first_vertex_, stippled_;
    std::uint32_t& stipple_counter_;
    RasterOutput& out_;
};

} // namespace legacygl
