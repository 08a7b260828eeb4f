#include "legacygl/cpu_pipeline/line_coverage.h"

#include <algorithm>
#include <cmath>

namespace legacygl {
namespace {

constexpr float GRID = 256;

constexpr float PIXEL_CENTER = 0.5f;

/// Rounds a window coordinate to the grid, which has pixel centres at whole numbers; halves away from 0.
float snapped(float a)
{
    const float scaled = GRID * (a - PIXEL_CENTER);
    return std::trunc(scaled >= 0 ? scaled + 0.5f : scaled - 0.5f) / GRID + PIXEL_CENTER;
}

bool sign(float x)
{
    return x >= 0;
}

float fraction(float x)
{
    return x - std::floor(x);
}

/// The line seen along its major axis: u is the coordinate that changes more, v the other.
struct End
{
    float u, v;
    float du() const { return u - std::floor(u) - 0.5f; }
    float dv() const { return v - std::floor(v) - 0.5f; }
};

/// How far the parallelogram's ends are moved along u, so that the diamond-exit rule holds.
struct EndOffsets
{
    float first = 0, second = 0;
};

/// Whether the pixels that hold the ends are to be drawn, by the diamond-exit rule.
struct DrawnEnds
{
    bool start, end;
};

DrawnEnds drawn_ends_x(const End& a, const End& b, float dx, float dy)
{
    const float slope = dy / dx, xa = a.du(), ya = a.dv(), xb = b.du();
    const float yb = b.dv() == -0.5f && dy < 0 ? 0.5f : b.dv();
    DrawnEnds drawn{};
    if (std::fabs(xa) + std::fabs(ya) < 0.5f) {
        drawn.start = true;
    } else if (sign(xa) == sign(-dx)) {
        drawn.start = false;
    } else if (sign(-ya) != sign(dy)) {
        drawn.start = true;
    } else {
        const float crossing = fraction(a.v) + xa * slope;
        drawn.start = crossing < 1 && crossing > 0;
    }
    if (std::fabs(xb) + std::fabs(yb) < 0.5f) {
        drawn.end = false;
    } else if (sign(xb) != sign(-dx)) {
        drawn.end = false;
    } else if (sign(-yb) == sign(dy)) {
        drawn.end = true;
    } else {
        const float crossing = fraction(b.v) + xb * slope;
        drawn.end = crossing < 1 && crossing > 0;
    }
    return drawn;
}

DrawnEnds drawn_ends_y(const End& a, const End& b, float dx, float dy)
{
    const float slope = dx / dy, xa = a.dv(), ya = a.du(), yb = b.du();
    const float xb = b.dv() == -0.5f && dx < 0 ? 0.5f : b.dv();
    DrawnEnds drawn{};
    if (std::fabs(xa) + std::fabs(ya) < 0.5f) {
        drawn.start = true;
    } else if (sign(-ya) == sign(dy)) {
        drawn.start = false;
    } else if (sign(xa) != sign(-dx)) {
        drawn.start = true;
    } else {
        const float crossing = fraction(a.v) + ya * slope;
        drawn.start = crossing < 1 && crossing > 0;
    }
    if (std::fabs(xb) + std::fabs(yb) < 0.5f) {
        drawn.end = false;
    } else if (sign(-yb) != sign(dy)) {
        drawn.end = false;
    } else if (sign(xb) == sign(-dx)) {
        drawn.end = true;
    } else {
        const float crossing = fraction(b.v) + yb * slope;
        drawn.end = crossing < 1 && crossing >= 0;
    }
    return drawn;
}

EndOffsets end_offsets_x(const End& a, const End& b, float dx, float dy)
{
    const DrawnEnds drawn = drawn_ends_x(a, b, dx, dy);
    const float xa = a.du(), xb = b.du();
    // A pixel whose centre is on the left edge is drawn, one on the right edge is not.
    const bool will_draw_start = dx < 0 ? xa <= 0 : xa > 0;
    const bool will_draw_end = dx < 0 ? xb > 0 : xb <= 0;
    const float edge = dx < 0 ? -0.5f : 0.5f;
    EndOffsets offsets;
    // A line to the left has its ends exchanged; the edge of the pixel is then on the other side.
    if (will_draw_start != drawn.start) {
        offsets.first = -xa + edge;
    }
    if (will_draw_end != drawn.end) {
        offsets.second = -xb + edge;
    }
    return offsets;
}

EndOffsets end_offsets_y(const End& a, const End& b, float dx, float dy)
{
    const DrawnEnds drawn = drawn_ends_y(a, b, dx, dy);
    const float ya = a.du(), yb = b.du();
    // So is one on the lower edge, and not on the upper one.
    const bool will_draw_start = dy > 0 ? ya > 0 : ya <= 0;
    const bool will_draw_end = dy > 0 ? yb <= 0 : yb > 0;
    const float edge = dy > 0 ? 0.5f : -0.5f;
    EndOffsets offsets;
    if (will_draw_start != drawn.start) {
        offsets.first = -ya + edge;
    }
    if (will_draw_end != drawn.end) {
        offsets.second = -yb + edge;
    }
    return offsets;
}

} // namespace

bool line_corners(const glm::vec4& first, const glm::vec4& second, float width,
                  std::array<LineCorner, 4>& corners)
{
    const float dx = first.x - second.x, dy = first.y - second.y;
    if (dx * dx + dy * dy == 0) {
        return false;
    }
    const bool x_major = std::fabs(dx) >= std::fabs(dy);
    const End a = x_major ? End{first.x, first.y} : End{first.y, first.x};
    const End b = x_major ? End{second.x, second.y} : End{second.y, second.x};
    const EndOffsets offsets = x_major ? end_offsets_x(a, b, dx, dy) : end_offsets_y(a, b, dx, dy);
    const float slope = x_major ? dy / dx : dx / dy;
    const float half = std::max(1.0f, std::trunc(std::max(1.0f, width) + 0.5f)) * 0.5f;
    const auto put = [&](int i, const End& end, float offset, float side) {
        const float u = snapped(end.u + offset), v = snapped(end.v + offset * slope) + side;
        const float along = (u - a.u) / (b.u - a.u);
        corners[i] = x_major ? LineCorner{u, v, along} : LineCorner{v, u, along};
    };
    put(0, a, offsets.first, -half);
    put(1, b, offsets.second, -half);
    put(2, b, offsets.second, half);
    put(3, a, offsets.first, half);
    return true;
}

} // namespace legacygl
