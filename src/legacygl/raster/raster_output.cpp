#include "legacygl/raster/raster_output.h"

#include "legacygl/shader_values.h"

namespace legacygl {

RasterOutput::RasterOutput(const ShaderKey& key, const ViewportTransform& viewport) : viewport_(viewport)
{
    const auto hold = [this](Attribute attribute, int components) {
        format_.components[index_of(attribute)] = static_cast<std::uint8_t>(components);
    };
    hold(Attribute::position, 4);
    hold(SHADED_EXTRA, 4);
    hold(Attribute::color, 4);
    if (key.secondary())
        hold(Attribute::secondary_color, 4);
    if (key.fog_mode)
        hold(Attribute::fog_coordinate, 1);
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit)
        if (key.textures[unit].format != BaseFormat::none)
            hold(texture_coordinate(unit), 4);
}

void RasterOutput::begin(PrimitiveClass primitive, Coverage coverage, bool polygons, bool grown)
{
    if (!draws_.empty()) {
        const ShadedDraw& last = draws_.back();
        if (last.primitive == primitive && last.coverage == coverage && last.polygons == polygons &&
            last.grown == grown)
            return;
    }
    draws_.push_back({primitive, coverage, polygons, grown, count_, 0});
}

void RasterOutput::add(const glm::vec4& clip, const glm::vec4& extra, const Varyings& varyings)
{
    const auto put = [this](const glm::vec4& v) { vertices_.insert(vertices_.end(), {v.x, v.y, v.z, v.w}); };
    put(clip);
    put(extra);
    put(varyings.color[0]);
    if (format_.has(Attribute::secondary_color))
        put(varyings.secondary[0]);
    if (format_.has(Attribute::fog_coordinate))
        vertices_.push_back(varyings.fog);
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit)
        if (format_.has(texture_coordinate(unit)))
            put(varyings.texture[unit]);
    ++count_;
    ++draws_.back().count;
}

void RasterOutput::point(const ShadedVertex& vertex)
{
    begin(PrimitiveClass::points, Coverage::whole, false, false);
    add(vertex.clip, glm::vec4(rasterised_point_size(vertex.point_size)), vertex.varyings);
}

void RasterOutput::line(const ShadedVertex& a, const ShadedVertex& b)
{
    begin(PrimitiveClass::lines, Coverage::whole, false, false);
    for (const ShadedVertex* v : {&a, &b})
        add(v->clip, {}, v->varyings);
}

void RasterOutput::triangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c)
{
    begin(PrimitiveClass::triangles, Coverage::whole, true, false);
    for (const ShadedVertex* v : {&a, &b, &c})
        add(v->clip, {}, v->varyings);
}

void RasterOutput::quadrilateral(Coverage coverage, const std::array<ShadedVertex, 4>& corners,
                                 const std::array<CoverageValues, 4>& values)
{
    begin(PrimitiveClass::triangles, coverage, false, true);
    // Cut as Mesa cuts it: a smooth line's corners are given as those of a strip.
    constexpr std::array<std::size_t, 6> around = {0, 1, 2, 0, 2, 3}, strip = {2, 1, 0, 3, 1, 2};
    for (const std::size_t i : coverage == Coverage::line ? strip : around)
        add(viewport_.clip(corners[i].window, VIEWPORT_MARGIN), values[i], corners[i].varyings);
}

} // namespace legacygl
