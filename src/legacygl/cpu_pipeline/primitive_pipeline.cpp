#include "legacygl/cpu_pipeline/primitive_pipeline.h"

#include "legacygl/cpu_pipeline/line_coverage.h"
#include "legacygl/cpu_pipeline/smooth_primitives.h"

#include <algorithm>
#include <cmath>

namespace legacygl {
namespace {

constexpr std::uint32_t EDGE_0 = 1, EDGE_1 = 2, EDGE_2 = 4;

/// Returns whether the vertex is somewhere in the window: w may be 0 at a place that no plane cuts off.
bool has_place(const ShadedVertex& vertex)
{
    return std::isfinite(vertex.window.x) && std::isfinite(vertex.window.y) &&
           std::isfinite(vertex.window.z) && std::isfinite(vertex.window.w);
}

/// Returns twice the triangle's area in the window, positive when it runs counter-clockwise.
float determinant(const std::array<ShadedVertex, 3>& t)
{
    const float ex = t[0].window.x - t[2].window.x, ey = t[0].window.y - t[2].window.y;
    const float fx = t[1].window.x - t[2].window.x, fy = t[1].window.y - t[2].window.y;
    return ex * fy - ey * fx;
}

/// Returns the vertex at t on the way from a to b in the window, where all values change evenly.
ShadedVertex between(const ShadedVertex& a, const ShadedVertex& b, float t)
{
    ShadedVertex out = a;
    out.window = a.window + t * (b.window - a.window);
    out.varyings = mix(a.varyings, b.varyings, t);
    return out;
}

/// Returns the vertex at t on the way from a to b in the window, where values change as perspective asks.
ShadedVertex in_perspective(const ShadedVertex& a, const ShadedVertex& b, float t)
{
    ShadedVertex out = a;
    out.window = a.window + t * (b.window - a.window);
    out.varyings = mix(a.varyings, b.varyings, a.window.w == b.window.w ? t : t * b.window.w / out.window.w);
    return out;
}

} // namespace

PrimitivePipeline::PrimitivePipeline(const State& state, const ShaderKey& key, const RasterWork& work,
                                     const VertexShading& shading, std::uint32_t& stipple_counter,
                                     RasterOutput& out)
    : state_(state), key_(key), work_(work), shading_(shading),
      first_vertex_(state.raster.provoking_vertex == GL_FIRST_VERTEX_CONVENTION),
      stippled_(state.raster.line_stipple.stipples()), stipple_counter_(stipple_counter), out_(out)
{}

void PrimitivePipeline::draw(GLenum mode, QuadOrder quad_order, std::span<const ShadedVertex> vertices)
{
    decompose(
        mode, static_cast<std::uint32_t>(vertices.size()), first_vertex_, quad_order,
        [&](std::uint32_t i) { point(vertices[i]); },
        [&](std::uint32_t i, std::uint32_t j, bool begins) { line(vertices[i], vertices[j], begins); },
        [&](const DecomposedTriangle& t) { polygon(vertices, t); });
}

void PrimitivePipeline::make_flat(std::span<ShadedVertex> vertices, std::size_t provoking) const
{
    if (!key_.flat) {
        return;
    }
    const Varyings from = vertices[provoking].varyings;
    for (ShadedVertex& vertex : vertices) {
        vertex.varyings.color = from.color;
        vertex.varyings.secondary = from.secondary;
    }
}

void PrimitivePipeline::point(const ShadedVertex& vertex)
{
    if (vertex.outside == 0) {
        draw_point(vertex);
    }
}

void PrimitivePipeline::line(const ShadedVertex& a, const ShadedVertex& b, bool begins)
{
    std::array<ShadedVertex, 2> line = {a, b};
    make_flat(line, first_vertex_ ? 0 : 1);
    if (!clip_line(shading_.volume(), shading_.viewport(), line)) {
        return;
    }
    if (begins) {
        stipple_counter_ = 0;
    }
    stippled_line(line[0], line[1]);
}

void PrimitivePipeline::polygon(std::span<const ShadedVertex> vertices, const DecomposedTriangle& from)
{
    Triangle whole = {vertices[from.vertices[0]], vertices[from.vertices[1]], vertices[from.vertices[2]]};
    make_flat(whole, first_vertex_ ? 0 : 2);
    const std::uint32_t outside = whole[0].outside | whole[1].outside | whole[2].outside;
    if (outside == 0) {
        return triangle(whole, from.edges, from.begins_polygon);
    }
    ClippedPolygon polygon;
    polygon.count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        polygon.vertices[i] = whole[i];
        polygon.edges[i] = from.edges >> i & 1;
    }
    if (!clip_polygon(shading_.volume(), shading_.viewport(), polygon)) {
        return;
    }
    if (!work_.unfilled && !ClipVolume::has_user_plane(outside)) {
        return whole_triangle(whole, polygon);
    }
    // A fan around the first vertex left, which takes the place of the provoking one.
    for (std::size_t i = 2, n = static_cast<std::size_t>(polygon.count); i < n; ++i) {
        const bool first = i == 2 && polygon.edges[0], middle = polygon.edges[i - 1],
                   last = i == n - 1 && polygon.edges[i];
        const ShadedVertex &v0 = polygon.vertices[0], &v1 = polygon.vertices[i - 1],
                           &v2 = polygon.vertices[i];
        Triangle part = first_vertex_ ? Triangle{v0, v1, v2} : Triangle{v1, v2, v0};
        const std::uint32_t edges = first_vertex_ ? first * EDGE_0 | middle * EDGE_1 | last * EDGE_2
                                                  : first * EDGE_2 | middle * EDGE_0 | last * EDGE_1;
        triangle(part, edges, i == 2);
    }
}

/// Draws a triangle that only the view volume cuts, which ES does as Mesa does. inside: what is left of it,
/// whose turning tells the face.
void PrimitivePipeline::whole_triangle(Triangle& whole, const ClippedPolygon& inside)
{
    float area = 0;
    for (std::size_t i = 2; area == 0 && i < static_cast<std::size_t>(inside.count); ++i) {
        area = determinant({inside.vertices[i - 1], inside.vertices[i], inside.vertices[0]});
    }
    choose_face(whole, area);
    stipple_counter_ = 0;
    out_.triangle(whole[0], whole[1], whole[2]);
}

/// Takes the colours of the face that a triangle of this area shows. Without an area it is the face that
/// turns counter-clockwise. Returns whether that is the back.
bool PrimitivePipeline::choose_face(Triangle& t, float area) const
{
    const bool back = state_.raster.front_face == GL_CCW ? area < 0 : area > 0;
    if (key_.two_side && back) {
        for (ShadedVertex& v : t) {
            v.varyings.color[0] = v.varyings.color[1];
            v.varyings.secondary[0] = v.varyings.secondary[1];
        }
    }
    return back;
}

void PrimitivePipeline::triangle(Triangle& t, std::uint32_t edges, bool begins)
{
    const RasterState& raster = state_.raster;
    const float area = determinant(t);
    const bool back = choose_face(t, area);
    // Where faces are culled, one without an area is a back face.
    if (work_.unfilled && raster.culls(back || area == 0 ? 1 : 0)) {
        return;
    }
    const bool back_mode = back || (area == 0 && raster.front_face != GL_CCW);
    const GLenum mode = raster.drawn_mode(back_mode ? 1 : 0);
    if (!work_.unfilled || mode == GL_FILL) {
        if (work_.unfilled) {
            offset(t, area, GL_FILL);
        }
        stipple_counter_ = 0;
        return out_.triangle(t[0], t[1], t[2]);
    }
    offset(t, area, mode);
    const auto drawn = [&](std::size_t i) { return (edges >> i & 1) && t[i].edge_flag; };
    if (mode == GL_POINT) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (drawn(i)) {
                draw_point(t[i]);
            }
        }
        return;
    }
    if (begins) {
        stipple_counter_ = 0;
    }
    for (const std::size_t i : {2u, 0u, 1u}) {
        if (drawn(i)) {
            stippled_line(t[i], t[(i + 1) % 3]);
        }
    }
}

/// Polygon offset (OpenGL 1.5, 3.5.5), at the vertices.
void PrimitivePipeline::offset(Triangle& t, float area, GLenum mode) const
{
    constexpr float MIN_DEPTH_STEP = 2.0f / 16777215.0f; // Of 24 bits, as Mesa counts them.
    const RasterState& raster = state_.raster;
    const bool enabled = mode == GL_POINT  ? raster.polygon_offset_point
                         : mode == GL_LINE ? raster.polygon_offset_line
                                           : raster.polygon_offset_fill;
    if (!enabled) {
        return;
    }
    const glm::vec4 e = t[0].window - t[2].window, f = t[1].window - t[2].window;
    float slope = 0;
    if (area != 0) {
        slope =
            std::max(std::fabs((e.y * f.z - e.z * f.y) / area), std::fabs((e.z * f.x - e.x * f.z) / area));
    }
    const float by = raster.polygon_offset_units * MIN_DEPTH_STEP + slope * raster.polygon_offset_factor;
    for (ShadedVertex& v : t) {
        v.window.z = std::min(std::max(v.window.z + by, 0.0f), 1.0f);
        v.moved = true;
    }
}

/// Cuts a line into the stretches that the stipple draws (OpenGL 1.5, 3.4.2).
void PrimitivePipeline::stippled_line(const ShadedVertex& a, const ShadedVertex& b)
{
    if (!stippled_) {
        return draw_line(a, b, false);
    }
    const LineStipple& stipple = state_.raster.line_stipple;
    const float dx = std::fabs(b.window.x - a.window.x), dy = std::fabs(b.window.y - a.window.y);
    const float length = state_.raster.line_smooth ? std::sqrt(dx * dx + dy * dy) : std::max(dx, dy);
    if (!std::isfinite(length)) {
        return;
    }
    const auto steps = static_cast<std::uint32_t>(std::ceil(length));
    const auto is_on = [&](std::uint32_t i) {
        const std::uint32_t bit = (stipple_counter_ + i) / static_cast<std::uint32_t>(stipple.factor) & 15;
        return (stipple.pattern >> bit & 1) != 0;
    };
    const auto draw_stretch = [&](std::uint32_t from, float to) {
        const float t = static_cast<float>(from) / length;
        draw_line(t > 0 ? between(a, b, t) : a, to < 1 ? between(a, b, to) : b, true);
    };
    bool on = false;
    std::uint32_t start = 0;
    for (std::uint32_t i = 0; i < steps; ++i) {
        if (is_on(i) == on) {
            continue;
        }
        if (on) {
            draw_stretch(start, static_cast<float>(i) / length);
        }
        start = i;
        on = !on;
    }
    if (on && static_cast<float>(start) < length) {
        draw_stretch(start, 1);
    }
    stipple_counter_ += steps;
}

/// cut: the ends' clip coordinates are not theirs any more.
void PrimitivePipeline::draw_line(const ShadedVertex& a, const ShadedVertex& b, bool cut)
{
    if (!has_place(a) || !has_place(b)) {
        return;
    }
    if (work_.smooth_lines) {
        return add_smooth_line(a, b, state_.raster.line_width, out_);
    }
    if (!cut && !work_.line_quads) {
        return out_.line(a, b, work_.beyond_viewport);
    }
    std::array<LineCorner, 4> corners;
    if (!line_corners(a.window, b.window, std::min(state_.raster.line_width, MAX_LINE_WIDTH), corners)) {
        return;
    }
    std::array<ShadedVertex, 4> vertices;
    for (std::size_t i = 0; i < 4; ++i) {
        vertices[i] = in_perspective(a, b, corners[i].along);
        vertices[i].window.x = corners[i].x;
        vertices[i].window.y = corners[i].y;
    }
    out_.quadrilateral(Coverage::whole, vertices, {});
}

void PrimitivePipeline::draw_point(const ShadedVertex& vertex)
{
    stipple_counter_ = 0;
    if (!has_place(vertex)) {
        return;
    }
    if (work_.smooth_points) {
        return add_smooth_point(vertex, state_.raster.point_parameters.attenuates(), out_);
    }
    out_.point(vertex);
}

} // namespace legacygl
