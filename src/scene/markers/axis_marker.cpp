#include "scene/markers/axis_marker.h"

namespace scene {
namespace {

constexpr Rgb AXIS_COLOUR = {225, 40, 170};
constexpr double PIVOT_RADIUS = 0.07; // metres
constexpr double BEFORE_PIVOT = 0.6;
constexpr double BEYOND_PIVOT = 1.6;

} // namespace

void draw_axis(const app::AxisInFrame& axis, const MarkerPen& pen)
{
    if (!axis.is_shown) {
        return;
    }
    const glm::dvec3 tip = axis.origin + BEYOND_PIVOT * axis.direction;
    pen.line(AXIS_COLOUR, axis.origin - BEFORE_PIVOT * axis.direction, tip);
    pen.arrow_head(AXIS_COLOUR, tip, axis.direction);
    pen.ball(AXIS_COLOUR, axis.origin, PIVOT_RADIUS);
}

} // namespace scene
