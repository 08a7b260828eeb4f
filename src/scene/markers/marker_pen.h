#pragma once

#include "app/view/camera_view.h"
#include "scene/drawing/rgb.h"
#include "scene/drawing/shapes.h"

#include <glm/vec3.hpp>
#include <span>

namespace scene {

/// Draws marks that can be read at every distance: balls, lines, arrow heads. Metres, in the world; the
/// modelview matrix is the view.
class MarkerPen
{
public:
    /// camera: of the frame. opacity: of everything it draws, 0 to 1.
    MarkerPen(const app::CameraView& camera, const Shapes& shapes, float opacity);

    /// Draws a ball, lit, at least as large as a mark has to be to be seen.
    void ball(Rgb colour, const glm::dvec3& centre, double radius) const;

    /// Draws a ring around such a ball, which faces the eye.
    void ring(Rgb colour, const glm::dvec3& centre, double radius) const;

    /// Draws an arrow head, lit, that points in a direction of unit length and begins at `base`.
    void arrow_head(Rgb colour, const glm::dvec3& base, const glm::dvec3& direction) const;

    void line(Rgb colour, const glm::dvec3& from, const glm::dvec3& to) const;

    /// Draws a line that fades away towards its end.
    void fading_line(Rgb colour, const glm::dvec3& from, const glm::dvec3& to) const;

    /// Draws a triangle's area, both sides, and its edges.
    void triangle(Rgb colour, std::span<const glm::dvec3, 3> corners) const;

private:
    double seen_size(const glm::dvec3& place, double size) const;
    void set_colour(Rgb colour, float opacity = 1.0f) const;

    const Shapes& shapes_;
    float opacity_;
    glm::dvec3 eye_;
    app::ViewAxes axes_;
};

} // namespace scene
