#include "app/camera_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace app {

namespace {

constexpr double FIELD_OF_VIEW = std::numbers::pi / 4.0; // 45 degrees, as in the handout

/// Beyond the tank by this much things can still be seen. Metres.
constexpr double SEEN_BEHIND = 600.0;

} // namespace

CameraView camera_view(const State& state)
{
    const Camera& camera = state.camera;
    const glm::dvec3 centre = glm::dvec3(state.x, 0.0, state.z) + camera.look;
    const double level = std::cos(camera.tilt);
    const glm::dvec3 towards_eye(level * std::sin(camera.orbit), std::sin(camera.tilt),
                                 level * std::cos(camera.orbit));
    const glm::dvec3 eye = centre + camera.distance * towards_eye;
    // The ground at the lower edge of the window is at least 0.92 of the eye's height deep (cos 22.5
    // degrees), at any tilt; it must not be cut off. A near plane of 1 m keeps a step of 24-bit depth at 400
    // m to a centimetre.
    const double near_plane = std::min({0.05 * camera.distance, 0.9 * eye.y, 1.0});
    return {.eye = eye,
            .centre = centre,
            .up = {0.0, 1.0, 0.0},
            .field_of_view = FIELD_OF_VIEW,
            .near_plane = near_plane,
            .far_plane = camera.distance + SEEN_BEHIND};
}

ViewAxes view_axes(const CameraView& camera)
{
    const glm::dvec3 forward = glm::normalize(camera.centre - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    return {right, glm::cross(right, forward), forward, 2.0 * std::tan(camera.field_of_view / 2.0)};
}

glm::dvec3 direction_through(const ViewAxes& axes, const glm::dvec2& aim)
{
    return axes.forward + axes.heights_per_depth * (aim.x * axes.right + aim.y * axes.up);
}

} // namespace app
