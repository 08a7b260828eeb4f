#pragma once

#include "app/assets.h"
#include "app/state.h"
#include "tank/joint.h"

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

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

/// Holds one tank to draw; the heading is a joint.
struct TankInFrame
{
    glm::dvec3 position; ///< where it stands, metres
    tank::JointAngles joints;
    Level level;
};

/// Holds everything that scene/ needs to draw one picture, besides the assets. Without a heap, copied freely.
struct Frame
{
    static constexpr std::size_t MOST_TANKS = 2;

    CameraView camera;
    std::array<TankInFrame, MOST_TANKS> tanks;
    std::size_t tank_count;
    bool ground; ///< draw it

    std::span<const TankInFrame> used_tanks() const { return {tanks.data(), tank_count}; }
};

/// Computes the frame of a state. Pure: the same state and assets give the same frame.
/// The eye is above the ground for every state within the limits of the fields.
Frame make_frame(const State& state, const Assets& assets);

} // namespace app
