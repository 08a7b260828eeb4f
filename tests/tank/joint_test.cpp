#include "tank/joint.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace tank {
namespace {

using std::numbers::pi;

constexpr Joint ALL_JOINTS[] = {
    Joint::heading,     Joint::turret,      Joint::main_gun, Joint::secondary_gun, Joint::secondary_gun_pitch,
    Joint::wheels_left, Joint::wheels_right};
static_assert(std::size(ALL_JOINTS) == JOINT_COUNT);

TEST(JointTest, OnlyTheGunsStop)
{
    for (Joint joint : ALL_JOINTS) {
        const bool is_gun =
            joint == Joint::main_gun || joint == Joint::secondary_gun || joint == Joint::secondary_gun_pitch;
        EXPECT_EQ(joint_limits(joint).wraps, !is_gun);
    }
    EXPECT_DOUBLE_EQ(joint_limits(Joint::main_gun).minimum, -9.0 * pi / 180.0);
    EXPECT_DOUBLE_EQ(joint_limits(Joint::main_gun).maximum, 20.0 * pi / 180.0);
    EXPECT_DOUBLE_EQ(joint_limits(Joint::secondary_gun).minimum, -120.0 * pi / 180.0);
    EXPECT_DOUBLE_EQ(joint_limits(Joint::secondary_gun).maximum, 120.0 * pi / 180.0);
    EXPECT_DOUBLE_EQ(joint_limits(Joint::secondary_gun_pitch).minimum, -10.0 * pi / 180.0);
    EXPECT_DOUBLE_EQ(joint_limits(Joint::secondary_gun_pitch).maximum, 60.0 * pi / 180.0);
}

TEST(JointTest, GunsAreClampedToTheirLimitsExactly)
{
    const JointLimits limits = joint_limits(Joint::main_gun);
    EXPECT_EQ(within_limits(limits, 1.0), limits.maximum);
    EXPECT_EQ(within_limits(limits, -1.0), limits.minimum);
    EXPECT_EQ(within_limits(limits, 1e300), limits.maximum);
    EXPECT_EQ(within_limits(limits, 0.1), 0.1);
}

TEST(JointTest, WrappingLeavesTheEndOut)
{
    const JointLimits limits = joint_limits(Joint::turret);
    EXPECT_EQ(within_limits(limits, pi), -pi);
    EXPECT_EQ(within_limits(limits, -pi), -pi);
    EXPECT_EQ(within_limits(limits, 3.0 * pi), -pi);
    EXPECT_EQ(within_limits(limits, std::nextafter(pi, 0.0)), std::nextafter(pi, 0.0));
}

TEST(JointTest, WrappingGoesRoundByWholeTurnsAndKeepsWhatIsWithin)
{
    const JointLimits limits = joint_limits(Joint::heading);
    std::mt19937 random(7);
    for (int i = 0; i < 10000; ++i) {
        const double angle = (static_cast<double>(random()) / 4294967296.0 - 0.5) * 100.0;
        const double wrapped = within_limits(limits, angle);
        ASSERT_GE(wrapped, -pi);
        ASSERT_LT(wrapped, pi);
        const double turns = (angle - wrapped) / (2.0 * pi);
        ASSERT_NEAR(turns, std::round(turns), 1e-12);
        ASSERT_EQ(within_limits(limits, wrapped), wrapped);
    }
    EXPECT_TRUE(std::isfinite(within_limits(limits, 1e300)));
}

TEST(JointTest, AnglesAreReadAndSetByJoint)
{
    JointAngles angles;
    for (Joint joint : ALL_JOINTS) {
        EXPECT_EQ(angles[joint], 0.0);
    }
    JointAngles other = angles;
    other[Joint::turret] = 0.5;
    EXPECT_NE(other, angles);
    EXPECT_EQ(other.radians[index_of(Joint::turret)], 0.5);
}

} // namespace
} // namespace tank
