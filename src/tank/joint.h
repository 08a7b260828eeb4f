#pragma once

#include <array>
#include <cstddef>

namespace tank {

/// Names what can turn: each joint moves one part or, for the wheels, one side of the tank. The secondary gun
/// has two.
enum class Joint
{
    heading,
    turret,
    main_gun,
    secondary_gun,       ///< its yaw
    secondary_gun_pitch, ///< within its yaw
    wheels_left,
    wheels_right,
};

constexpr std::size_t JOINT_COUNT = 7;

/// Returns the index of a joint, in [0, JOINT_COUNT).
constexpr std::size_t index_of(Joint joint)
{
    return static_cast<std::size_t>(joint);
}

/// Says how far a joint turns. Radians; minimum <= maximum.
/// A joint that wraps turns all the way round: its angles are kept in [minimum, maximum) = [-pi, pi).
struct JointLimits
{
    bool wraps;
    double minimum;
    double maximum;
};

/// Returns the limits of a joint. This is the only place where they are written.
JointLimits joint_limits(Joint joint);

/// Holds an angle in radians for every joint; all zero is the tank at rest, gun forward and level.
struct JointAngles
{
    std::array<double, JOINT_COUNT> radians{};

    constexpr double& operator[](Joint joint) { return radians[index_of(joint)]; }
    constexpr double operator[](Joint joint) const { return radians[index_of(joint)]; }
    friend bool operator==(const JointAngles&, const JointAngles&) = default;
};

/// Returns the angle, in radians, brought within the limits: wrapped into [-pi, pi), or clamped.
/// Angles already within are returned unchanged, to the bit. Precondition: radians is finite.
double within_limits(const JointLimits& limits, double radians);

} // namespace tank
