#pragma once

#include "legacygl/primitives.h"
#include "legacygl/raster/shaded_vertex.h"
#include "legacygl/raster/viewport_transform.h"
#include "legacygl/shader_key.h"

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
};

/// What a smooth line or point carries besides (see Coverage): what becomes of it is up to the fragments.
using CoverageValues = glm::vec4;

/// Collects shaded primitives in the order they were drawn, in a vertex format that holds what the key's
/// fragments read.
class RasterOutput
{
public:
    /// The greatest a line or point reaches beyond its own coordinates, in pixels.
    static constexpr int VIEWPORT_MARGIN = 256;

    RasterOutput(const ShaderKey& key, const ViewportTransform& viewport);

    void point(const ShadedVertex& vertex);
    void line(const ShadedVertex& a, const ShadedVertex& b);
    void triangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c);
    /// A quadrilateral that stands for a line or a point: its corners are where their window coordinates say.
    void quadrilateral(Coverage coverage, const std::array<ShadedVertex, 4>& corners,
                       const std::array<CoverageValues, 4>& values);

    const VertexFormat& format() const { return format_; }
    const std::vector<float>& vertices() const { return vertices_; }
    const std::vector<ShadedDraw>& draws() const { return draws_; }

private:
    void begin(PrimitiveClass primitive, Coverage coverage, bool polygons, bool grown);
    void add(const glm::vec4& clip, const glm::vec4& extra, const Varyings& varyings);

    const ViewportTransform& viewport_;
    VertexFormat format_;
    std::vector<float> vertices_;
    std::vector<ShadedDraw> draws_;
    std::uint32_t count_ = 0;
};

} // namespace legacygl
