#pragma once

#include "legacygl/cpu_pipeline/pixel_box.h"
#include "legacygl/cpu_pipeline/shaded_vertex.h"
#include "legacygl/cpu_pipeline/viewport_transform.h"
#include "legacygl/shader/shader_key.h"
#include "legacygl/vertex/primitives.h"

#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace legacygl {

/// Points, lines or triangles of shaded vertices that one draw call can draw.
struct ShadedDraw
{
    PrimitiveClass primitive;
    Coverage coverage;
    bool polygons; ///< They are filled polygons, which a stipple may cover.
    bool grown;    ///< The viewport is grown by VIEWPORT_MARGIN: see ViewportTransform::clip.
    std::uint32_t first, count;
    PixelBox box; ///< Holds all of its pixels.
};

/// What a smooth line or point carries besides (see Coverage): what becomes of it is up to the fragments.
using CoverageValues = glm::vec4;

/// Collects shaded primitives in the order they were drawn, in a vertex format that holds what the key's
/// fragments read.
class RasterOutput
{
public:
    /// line_reach: half of the width of lines that are drawn as lines. apart: no two primitives of a draw
    /// may have a pixel in common.
    RasterOutput(const ShaderKey& key, const ViewportTransform& viewport, float line_reach, bool apart);

    void point(const ShadedVertex& vertex);
    /// reaches: whether some of it may be drawn beyond the viewport.
    void line(const ShadedVertex& a, const ShadedVertex& b, bool reaches);
    /// The corners may be outside of the view volume.
    void triangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c);
    /// A quadrilateral that stands for a line or a point: its corners are where their window coordinates say.
    void quadrilateral(Coverage coverage, const std::array<ShadedVertex, 4>& corners,
                       const std::array<CoverageValues, 4>& values);

    const VertexFormat& format() const { return format_; }
    const std::vector<float>& vertices() const { return vertices_; }
    const std::vector<ShadedDraw>& draws() const { return draws_; }

private:
    void begin(const ShadedDraw& wanted, const PixelBox& box);
    bool overlaps_last_draw(const PixelBox& box) const;
    glm::vec4 clip_of(const ShadedVertex& vertex) const;
    void add(const glm::vec4& clip, const glm::vec4& extra, const Varyings& varyings);

    const ViewportTransform& viewport_;
    const ViewportTransform grown_viewport_; ///< By VIEWPORT_MARGIN.
    const float line_reach_;
    const bool apart_;
    VertexFormat format_;
    std::vector<float> vertices_;
    std::vector<ShadedDraw> draws_;
    std::vector<PixelBox> boxes_; ///< Of the primitives of the last draw, if they must be apart.
    std::uint32_t count_ = 0;
};

} // namespace legacygl
