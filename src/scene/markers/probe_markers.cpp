#include "scene/markers/probe_markers.h"

#include "scene/markers/level_colours.h"

#include <glm/geometric.hpp>

namespace scene {
namespace {

constexpr Rgb PROBE_COLOUR = {255, 230, 60};
constexpr Rgb MOVED_COLOUR = {255, 255, 255};

constexpr double HANDLE_RADIUS = 0.09; // metres
constexpr double CLOSEST_POINT_RADIUS = 0.06;
constexpr double CENTRE_RADIUS = 0.04;

/// Draws a place that can be moved, and marks it if it is the one that the keys move.
void draw_handle(const app::ProbeInFrame& probe, app::Handle handle, const glm::dvec3& place, double radius,
                 const MarkerPen& pen)
{
    pen.ball(PROBE_COLOUR, place, radius);
    if (probe.handle == handle) {
        pen.ring(MOVED_COLOUR, place, radius);
    }
}

void draw_line(const app::ProbeInFrame& probe, const MarkerPen& pen)
{
    pen.line(PROBE_COLOUR, probe.from, probe.to);
    draw_handle(probe, app::Handle::line_a, probe.a, HANDLE_RADIUS, pen);
    draw_handle(probe, app::Handle::line_b, probe.b, HANDLE_RADIUS, pen);
    // A line that goes on says so beyond its handle.
    const glm::dvec3 along = probe.b - probe.a;
    const double length = glm::length(along);
    if (length > 0.0) {
        const glm::dvec3 direction = along / length;
        if (probe.to != probe.b) {
            pen.arrow_head(PROBE_COLOUR, probe.b + direction, direction);
        }
        if (probe.from != probe.a) {
            pen.arrow_head(PROBE_COLOUR, probe.a - direction, -direction);
        }
    }
}

void draw_closest_points(const app::Frame& frame, const MarkerPen& pen)
{
    for (const app::ClosestPointInFrame& closest : frame.closest_points) {
        const Rgb colour = level_colour(closest.is_root);
        pen.line(colour, closest.point, closest.centre);
        pen.ball(colour, closest.centre, CENTRE_RADIUS);
        // Of a point every closest point is the point itself, which is drawn.
        if (frame.probe.probe != app::Probe::point) {
            pen.ball(colour, closest.point, CLOSEST_POINT_RADIUS);
        }
    }
}

} // namespace

void draw_probe(const app::Frame& frame, const MarkerPen& pen)
{
    if (frame.probe.probe == app::Probe::none) {
        return;
    }
    if (frame.probe.probe == app::Probe::point) {
        draw_handle(frame.probe, app::Handle::point, frame.probe.point, frame.probe.point_radius, pen);
    } else {
        draw_line(frame.probe, pen);
    }
    draw_closest_points(frame, pen);
}

} // namespace scene
