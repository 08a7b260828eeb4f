#include "scene/markers/marker_pen.h"

#include "scene/drawing/scoped_state.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include <GL/gl.h>

namespace scene {
namespace {

/// No ball is smaller than this part of the window's height, in radius.
constexpr double MIN_RADIUS = 0.007;

/// The ring around a ball is so many times larger.
constexpr double RING_TO_BALL = 2.0;

/// The length of an arrow head is this part of the window's height; its radius is a third of that.
constexpr double ARROW_LENGTH = 0.04;

/// A triangle's area is fainter than its edges.
constexpr float AREA_OPACITY = 0.45f;

void vertex(const glm::dvec3& place)
{
    glVertex3d(place.x, place.y, place.z);
}

} // namespace

MarkerPen::MarkerPen(const app::CameraView& camera, const Shapes& shapes, float opacity)
    : shapes_(shapes), opacity_(opacity), eye_(camera.eye), axes_(app::view_axes(camera))
{}

void MarkerPen::ball(Rgb colour, const glm::dvec3& centre, double radius) const
{
    const Enabled lighting(GL_LIGHTING);
    set_colour(colour);
    shapes_.draw_ball(centre, std::max(radius, seen_size(centre, MIN_RADIUS)));
}

void MarkerPen::ring(Rgb colour, const glm::dvec3& centre, double radius) const
{
    set_colour(colour);
    const double size = RING_TO_BALL * std::max(radius, seen_size(centre, MIN_RADIUS));
    shapes_.draw_ring(centre, size * axes_.right, size * axes_.up);
}

void MarkerPen::arrow_head(Rgb colour, const glm::dvec3& base, const glm::dvec3& direction) const
{
    const Enabled lighting(GL_LIGHTING);
    set_colour(colour);
    const double length = seen_size(base, ARROW_LENGTH);
    shapes_.draw_cone(base, direction, length / 3.0, length);
}

void MarkerPen::line(Rgb colour, const glm::dvec3& from, const glm::dvec3& to) const
{
    set_colour(colour);
    glBegin(GL_LINES);
    vertex(from);
    vertex(to);
    glEnd();
}

void MarkerPen::fading_line(Rgb colour, const glm::dvec3& from, const glm::dvec3& to) const
{
    glBegin(GL_LINES);
    set_colour(colour);
    vertex(from);
    set_colour(colour, 0.0f);
    vertex(to);
    glEnd();
}

void MarkerPen::triangle(Rgb colour, std::span<const glm::dvec3, 3> corners) const
{
    set_colour(colour, AREA_OPACITY);
    glBegin(GL_TRIANGLES);
    std::for_each(corners.begin(), corners.end(), vertex);
    glEnd();
    set_colour(colour);
    glBegin(GL_LINE_LOOP);
    std::for_each(corners.begin(), corners.end(), vertex);
    glEnd();
}

/// Returns how many metres `size` window heights are at a place; behind the eye, none.
double MarkerPen::seen_size(const glm::dvec3& place, double size) const
{
    return size * axes_.heights_per_depth * std::max(0.0, glm::dot(place - eye_, axes_.forward));
}

void MarkerPen::set_colour(Rgb colour, float opacity) const
{
    glColor4ub(colour.red, colour.green, colour.blue,
               static_cast<GLubyte>(std::lround(255.0 * static_cast<double>(opacity_ * opacity))));
}

} // namespace scene
