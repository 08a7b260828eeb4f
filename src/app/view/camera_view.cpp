#include "app/view/camera_view.h"

#include "app/state/fields.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

namespace app {

namespace {

using std::numbers::pi;

/// Beyond the tank by this much things can still be seen. Metres.
constexpr double SEEN_BEHIND = 600.0;

/// Returns a vector turned about +Y. Radians.
glm::dvec3 turned(const glm::dvec3& vector, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * vector.x + s * vector.z, vector.y, c * vector.z - s * vector.x};
}

CameraView view_around(const State& state)
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

/// The eye behind the tank is a little higher and further away than going round it, so that it sees over the
/// turret where the gun points, and the horizon.
CameraView view_from_behind(State state)
{
    constexpr double HIGHER = 4.0 * pi / 180.0;
    constexpr double FURTHER = 1.35;
    Camera& camera = state.camera;
    const double heading = state.joints[tank::Joint::heading];
    camera.orbit = heading + pi + camera.chase;
    camera.tilt = std::min(camera.tilt + HIGHER, field(FieldId::tilt).maximum);
    camera.distance *= FURTHER;
    camera.look = turned(camera.look, heading);
    return view_around(state);
}

/// The gunner's sight magnifies by what the distance says: at that of the first view it shows 30 degrees.
CameraView view_through_sight(const State& state, const assets::Assets& assets)
{
    constexpr double SEEN_PER_DISTANCE = 0.0255; // half the height seen a metre away, for a metre of distance
    constexpr double WIDEST = 50.0 * pi / 180.0;
    constexpr double LOOKED_AT = 15.0; // metres before the eye
    const tank::PartMatrices matrices =
        tank::part_matrices(assets.layout, {{state.x, 0.0, state.z}}, state.joints);
    const glm::dmat4 turret(matrices.joint(tank::Part::turret));
    const glm::dvec3 eye(turret * glm::dvec4(assets.sight, 1.0));
    const glm::dvec3 along_barrel(glm::dmat4(matrices.joint(tank::Part::main_gun))[2]);
    return {.eye = eye,
            .centre = eye + LOOKED_AT * glm::normalize(along_barrel),
            .up = {0.0, 1.0, 0.0},
            .field_of_view = std::min(2.0 * std::atan(SEEN_PER_DISTANCE * state.camera.distance), WIDEST),
            .near_plane = 0.1,
            .far_plane = SEEN_BEHIND};
}

} // namespace

assets::PaintView paint_view()
{
    return {.field_of_view = FIELD_OF_VIEW, .distance = State{}.show.threshold};
}

CameraView camera_view(const State& state, const assets::Assets& assets)
{
    switch (state.camera.view) {
    case View::follow:
        return view_from_behind(state);
    case View::gunner:
        return view_through_sight(state, assets);
    case View::orbit:
    case View::four:
        break;
    }
    return view_around(state);
}

CameraView side_view(const State& state, SeenFrom side)
{
    constexpr double NARROW = 6.0 * pi / 180.0;
    const double heading = state.joints[tank::Joint::heading];
    const glm::dvec3 centre = glm::dvec3(state.x, 0.0, state.z) + turned(state.camera.look, heading);
    const double distance = state.camera.distance * std::tan(0.5 * FIELD_OF_VIEW) / std::tan(0.5 * NARROW);
    // From above the gun points to the left, as it does from the left side.
    const glm::dvec3 towards_eye = side == SeenFrom::front  ? glm::dvec3(0.0, 0.0, 1.0)
                                   : side == SeenFrom::left ? glm::dvec3(1.0, 0.0, 0.0)
                                                            : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 up = side == SeenFrom::above ? glm::dvec3(-1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return {.eye = centre + distance * turned(towards_eye, heading),
            .centre = centre,
            .up = turned(up, heading),
            .field_of_view = NARROW,
            .near_plane = 1.0,
            .far_plane = distance + SEEN_BEHIND};
}

double eye_distance(const State& state)
{
    return state.camera.view == View::gunner ? 0.0 : state.camera.distance;
}

double vertical_fov_scale(double aspect)
{
    constexpr double MIN_ASPECT = 5.0 / 4.0;
    return std::max(1.0, MIN_ASPECT / aspect);
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
