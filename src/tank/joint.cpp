#include "tank/joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tank {

namespace {

using std::numbers::pi;

constexpr double from_degrees(double degrees)
{
    return degrees * pi / 180.0;
}

constexpr JointLimits ALL_THE_WAY_ROUND{.wraps = true, .minimum = -pi, .maximum = pi};

constexpr std::array<JointLimits, JOINT_COUNT> LIMITS = {{
    /* heading             */ ALL_THE_WAY_ROUND,
    /* turret              */ ALL_THE_WAY_ROUND,
    /* main_gun            */ {.wraps = false, .minimum = from_degrees(-9.0), .maximum = from_degrees(20.0)},
    /* secondary_gun       */
    {.wraps = false, .minimum = from_degrees(-120.0), .maximum = from_degrees(120.0)},
    /* secondary_gun_pitch */ {.wraps = false, .minimum = from_degrees(-10.0), .maximum = from_degrees(60.0)},
    /* wheels_left         */ ALL_THE_WAY_ROUND,
    /* wheels_right        */ ALL_THE_WAY_ROUND,
}};

} // namespace

JointLimits joint_limits(Joint joint)
{
    return LIMITS[index_of(joint)];
}

double within_limits(const JointLimits& limits, double radians)
{
    if (!limits.wraps) {
        return std::clamp(radians, limits.minimum, limits.maximum);
    }
    if (radians >= limits.minimum && radians < limits.maximum) {
        return radians;
    }
    // remainder is exact, so it gives the same bits natively and in wasm. It may return +pi, the end left
    // out.
    const double wrapped = std::remainder(radians, 2.0 * pi);
    return wrapped >= limits.maximum ? limits.minimum : wrapped;
}

} // namespace tank
