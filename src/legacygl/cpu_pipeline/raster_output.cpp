#include "legacygl/cpu_pipeline/raster_output.h"

#include "legacygl/shader/shader_values.h"

#include <algorithm>

namespace legacygl {

RasterOutput::RasterOutput(const ShaderKey& key, const ViewportTransform& viewport, float line_reach,
                           bool apart)
    : viewport_(viewport), grown_viewport_(viewport.grown(VIEWPORT_MARGIN)), line_reach_(line_reach),
      apart_(apart)
{
    const auto hold = [this](Attribute attribute, int components) {
        format_.components[index_of(attribute)] = static_cast<std::uint8_t>(components);
    };
    hold(Attribute::position, 4);
    hold(SHADED_EXTRA, 4);
    hold(Attribute::color, 4);
    if (key.secondary()) {
        hold(Attribute::secondary_color, 4);
    }
    if (key.fog_mode) {
        hold(Attribute::fog_coordinate, 1);
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].format != BaseFormat::none) {
            hold(texture_coordinate(unit), 4);
        }
    }
}

bool RasterOutput::overlaps_last_draw(const PixelBox& box) const
{
    return std::any_of(boxes_.begin(), boxes_.end(),
                       [&](const PixelBox& other) { return box.overlaps(other); });
}

/// Begins a primitive: in the last draw where that is of the same kind.
void RasterOutput::begin(const ShadedDraw& wanted, const PixelBox& box)
{
    const ShadedDraw* last = draws_.empty() ? nullptr : &draws_.back();
    if (!last || last->primitive != wanted.primitive || last->coverage != wanted.coverage ||
        last->polygons != wanted.polygons || last->grown != wanted.grown ||
        (apart_ && overlaps_last_draw(box))) {
        draws_.push_back(wanted);
        draws_.back().first = count_;
        boxes_.clear();
    }
    if (!apart_) {
        return;
    }
    draws_.back().box.include(box);
    boxes_.push_back(box);
}

void RasterOutput::add(const glm::vec4& clip, const glm::vec4& extra, const Varyings& varyings)
{
    const auto put = [this](const glm::vec4& v) { vertices_.insert(vertices_.end(), {v.x, v.y, v.z, v.w}); };
    put(clip);
    put(extra);
    put(varyings.color[0]);
    if (format_.has(Attribute::secondary_color)) {
        put(varyings.secondary[0]);
    }
    if (format_.has(Attribute::fog_coordinate)) {
        vertices_.push_back(varyings.fog);
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (format_.has(texture_coordinate(unit))) {
            put(varyings.texture[unit]);
        }
    }
    ++count_;
    ++draws_.back().count;
}

glm::vec4 RasterOutput::clip_of(const ShadedVertex& vertex) const
{
    return vertex.moved ? viewport_.clip_onto(vertex.window, vertex.clip) : vertex.clip;
}

void RasterOutput::point(const ShadedVertex& vertex)
{
    begin({PrimitiveClass::points, Coverage::whole, false, true, 0, 0, {}},
          box_of({&vertex, 1}, vertex.point_size / 2));
    add(viewport_.clip(vertex.window, VIEWPORT_MARGIN), glm::vec4(rasterised_point_size(vertex.point_size)),
        vertex.varyings);
}

void RasterOutput::line(const ShadedVertex& a, const ShadedVertex& b, bool reaches)
{
    const std::array<ShadedVertex, 2> ends = {a, b};
    begin({PrimitiveClass::lines, Coverage::whole, false, reaches, 0, 0, {}}, box_of(ends, line_reach_));
    for (const ShadedVertex& v : ends) {
        add(reaches ? grown_viewport_.clip_onto(v.window, viewport_.clip(v.window, VIEWPORT_MARGIN))
                    : clip_of(v),
            {}, v.varyings);
    }
}

void RasterOutput::triangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c)
{
    const std::array<ShadedVertex, 3> corners = {a, b, c};
    const bool cut = (a.outside | b.outside | c.outside) != 0;
    begin({PrimitiveClass::triangles, Coverage::whole, true, false, 0, 0, {}},
          cut ? EVERYWHERE : box_of(corners, 0));
    for (const ShadedVertex& v : corners) {
        add(clip_of(v), {}, v.varyings);
    }
}

void RasterOutput::quadrilateral(Coverage coverage, const std::array<ShadedVertex, 4>& corners,
                                 const std::array<CoverageValues, 4>& values)
{
    begin({PrimitiveClass::triangles, coverage, false, true, 0, 0, {}}, box_of(corners, 0));
    // Cut as Mesa cuts it: a smooth line's corners are given as those of a strip.
    constexpr std::array<std::size_t, 6> FAN = {0, 1, 2, 0, 2, 3}, STRIP = {2, 1, 0, 3, 1, 2};
    for (const std::size_t i : coverage == Coverage::line ? STRIP : FAN) {
        add(viewport_.clip(corners[i].window, VIEWPORT_MARGIN), values[i], corners[i].varyings);
    }
}

} // namespace legacygl
