#include "scene/markers/triangle_markers.h"

namespace scene {
namespace {

constexpr Rgb INSIDE_COLOUR = {235, 30, 40};
constexpr Rgb OUTSIDE_COLOUR = {60, 230, 130};
constexpr double MIN_POINT_RADIUS = 0.05; // metres

} // namespace

void draw_triangles(const app::Frame& frame, const MarkerPen& pen)
{
    for (const app::TriangleInFrame& triangle : frame.triangles) {
        const Rgb colour = triangle.is_inside ? INSIDE_COLOUR : OUTSIDE_COLOUR;
        pen.triangle(colour, triangle.corners);
        pen.ball(colour, triangle.point, MIN_POINT_RADIUS);
        pen.line(colour, triangle.point, frame.probe.point);
    }
}

} // namespace scene
