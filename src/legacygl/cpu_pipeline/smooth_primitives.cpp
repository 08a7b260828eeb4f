#include "legacygl/cpu_pipeline/smooth_primitives.h"

#include "legacygl/state/raster.h"

#include <algorithm>
#include <cmath>

namespace legacygl {

void add_smooth_line(const ShadedVertex& a, const ShadedVertex& b, float width, RasterOutput& out)
{
    const float dx = b.window.x - a.window.x, dy = b.window.y - a.window.y;
    const float length = std::sqrt(dx * dx + dy * dy);
    if (length == 0) {
        return;
    }
    const float c = dx / length, s = dy / length;
    const float clamped_width = std::min(std::max(width, 1.0f), MAX_LINE_WIDTH);
    const float half_width = clamped_width <= 1 ? 1.0f : 0.5f * clamped_width + 0.5f;
    const float half_length = 0.5f * length + 0.5f;
    std::array<ShadedVertex, 4> corners = {a, a, b, b};
    std::array<CoverageValues, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) {
        const float along = i < 2 ? -1.0f : 1.0f, across = i % 2 == 0 ? 1.0f : -1.0f;
        corners[i].window.x += along * 0.5f * c - across * half_width * s;
        corners[i].window.y += along * 0.5f * s + across * half_width * c;
        values[i] = {-across * half_width, half_width, along * half_length, half_length};
    }
    out.quadrilateral(Coverage::line, corners, values);
}

void add_smooth_point(const ShadedVertex& vertex, bool attenuated, RasterOutput& out)
{
    const float radius =
        vertex.point_size <= 2 && !attenuated ? 1.0f : 0.5f * std::max(1.0f, vertex.point_size);
    const float reciprocal = 1 / radius;
    const float full_within = 1 - 2 * reciprocal + reciprocal * reciprocal;
    std::array<ShadedVertex, 4> corners = {vertex, vertex, vertex, vertex};
    std::array<CoverageValues, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) {
        const float x = i == 1 || i == 2 ? 1.0f : -1.0f, y = i >= 2 ? 1.0f : -1.0f;
        corners[i].window.x += x * radius;
        corners[i].window.y += y * radius;
        values[i] = {x, y, full_within, 1};
    }
    out.quadrilateral(Coverage::point, corners, values);
}

} // namespace legacygl
