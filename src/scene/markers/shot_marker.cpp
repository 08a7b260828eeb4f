#include "scene/markers/shot_marker.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace scene {
namespace {

constexpr Rgb SHOT_COLOUR = {255, 240, 170};
constexpr Rgb TRAIL_COLOUR = {255, 190, 90};

/// The trail is as long as the way of this time, in seconds, within limits in metres.
constexpr double TRAIL_TIME = 0.08;
constexpr double MIN_TRAIL = 0.8;
constexpr double MAX_TRAIL = 6.0;

} // namespace

void draw_shot(const app::ShotInFrame& shot, const MarkerPen& pen)
{
    if (!shot.flies) {
        return;
    }
    const double speed = glm::length(shot.velocity);
    if (speed > 0.0) {
        const double length = std::clamp(speed * TRAIL_TIME, MIN_TRAIL, MAX_TRAIL);
        pen.fading_line(TRAIL_COLOUR, shot.position, shot.position - shot.velocity * (length / speed));
    }
    pen.ball(SHOT_COLOUR, shot.position, shot.radius);
}

} // namespace scene
