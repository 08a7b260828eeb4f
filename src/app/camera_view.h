#pragma once

#include "app/state.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace app {

/// Holds what gluLookAt and gluPerspective need. Metres, radians.
struct CameraView
{
    glm::dvec3 eye;
    glm::dvec3 centre;
    glm::dvec3 up;
    double field_of_view; ///< from the bottom to the top of the window
    double near_plane;
    double far_plane;
};

/// Returns the view of a state. The eye is above the ground for every state within the limits of the fields.
/// With orbit, tilt, look_x and look_z 0 and a distance of 20 m and more it is the handout's camera: 45
/// degrees, near plane 1, looking along -Z, the tank `distance` away along -Z; the far plane is extended.
CameraView camera_view(const State& state);

/// Says where things are in the window: the axes of a view, each of unit length.
struct ViewAxes
{
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
    double heights_per_depth; ///< so many metres a window height is for each metre of depth
};

/// Returns the axes of a view.
ViewAxes view_axes(const CameraView& camera);

/// Returns the direction from the eye through a place in the window, `aim` as in Projectile; 1 along forward.
glm::dvec3 direction_through(const ViewAxes& axes, const glm::dvec2& aim);

} // namespace app
