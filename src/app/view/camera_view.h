#pragma once

#include "app/state/state.h"
#include "assets/assets.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <string_view>

namespace app {

/// How much the view from around shows from the bottom to the top of the window: 45 degrees, as in the
/// handout.
constexpr double FIELD_OF_VIEW = std::numbers::pi / 4.0;

/// Returns the view in which the low tank takes the place of the high one, as long as nobody sets another
/// threshold: what the low one is painted for.
assets::PaintView paint_view();

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

/// Returns the view of a state; of four, the last one. The eye is above the ground for every state within the
/// limits of the fields. With orbit, tilt, look_x and look_z 0 and a distance of 20 m and more it is the
/// handout's camera: 45 degrees, near plane 1, looking along -Z, the tank `distance` away along -Z; the far
/// plane is extended. assets: of the tank that is shown, whose sight the gunner looks through.
CameraView camera_view(const State& state, const assets::Assets& assets);

/// Names three sides that a tank is seen from, wherever it heads.
enum class SeenFrom : std::uint8_t
{
    front,
    left,
    above,
};

/// Returns a view of the tank from one side, from so far away that all of it is seen nearly in parallel. It
/// shows as much as camera_view() does at the same distance.
CameraView side_view(const State& state, SeenFrom side);

/// Returns how far the eye is from the tank, by which its level of detail goes. Metres.
double eye_distance(const State& state);

/// Returns how much more a narrow window shows from bottom to top than CameraView::field_of_view says, so
/// that it shows as much from side to side as one of 5 : 4: 1 for any wider one. aspect: width / height.
double vertical_fov_scale(double aspect);

/// Says where things are in the window: the axes of a view, each of unit length.
struct ViewAxes
{
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
    double heights_per_depth; ///< so many metres a window height is for each metre of depth
};

/// Says why nothing can be aimed at while four views share the window.
constexpr std::string_view NO_AIM_IN_FOUR_VIEWS = "With four views in the window nothing can be aimed at.";

/// Returns the axes of a view.
ViewAxes view_axes(const CameraView& camera);

/// Returns the direction from the eye through a place in the window, `aim` as in Projectile; 1 along forward.
glm::dvec3 direction_through(const ViewAxes& axes, const glm::dvec2& aim);

} // namespace app
