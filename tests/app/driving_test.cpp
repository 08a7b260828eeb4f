#include "app/simulation/simulation.h"
#include "app/state/ticks.h"
#include "fixtures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <numbers>

namespace app {
namespace {

using tank::Joint;

constexpr double PI = std::numbers::pi;

void hold(Simulation& simulation, std::initializer_list<std::string_view> commands, int ticks)
{
    for (std::string_view command : commands) {
        EXPECT_EQ(simulation.apply(command, 1.0).refusal, "");
    }
    for (int tick = 0; tick < ticks; ++tick) {
        simulation.step();
    }
    for (std::string_view command : commands) {
        EXPECT_EQ(simulation.apply(command, 0.0).refusal, "");
    }
}

/// Returns an angle that has gone from one to another, less than half a turn.
double turned(double from, double to)
{
    return std::remainder(to - from, 2.0 * PI);
}

TEST(DrivingTest, GoesStraightAheadWhereTheTankFaces)
{
    for (double heading : {0.0, 90.0, -135.0, 37.0}) {
        Simulation simulation(assets::own_assets());
        simulation.apply("heading", heading);
        hold(simulation, {"drive_forward"}, TICKS_PER_SECOND);
        const double angle = heading * PI / 180.0;
        EXPECT_NEAR(simulation.state().x, 5.0 * std::sin(angle), 1e-4);
        EXPECT_NEAR(simulation.state().z, 5.0 * std::cos(angle), 1e-4);
        hold(simulation, {"drive_backward"}, TICKS_PER_SECOND);
        EXPECT_NEAR(std::hypot(simulation.state().x, simulation.state().z), 0.0, 1e-4);
    }
}

TEST(DrivingTest, RollsBothSidesByTheGroundCovered)
{
    Simulation simulation(assets::own_assets());
    const int ticks = 6;
    hold(simulation, {"drive_forward"}, ticks);
    const double covered = 5.0 * ticks / TICKS_PER_SECOND;
    const tank::JointAngles& joints = simulation.state().joints;
    EXPECT_GT(assets::own_assets().wheel_radius, 0.3);
    EXPECT_NEAR(turned(0.0, joints[Joint::wheels_left]) * assets::own_assets().wheel_radius, covered, 1e-9);
    EXPECT_EQ(joints[Joint::wheels_left], joints[Joint::wheels_right]);
}

TEST(DrivingTest, RollsTheSidesAgainstEachOtherInTurningInPlace)
{
    Simulation simulation(assets::own_assets());
    hold(simulation, {"turn_left"}, 20);
    const tank::JointAngles& joints = simulation.state().joints;
    const double half = assets::own_assets().layout[tank::Part::wheel_left_1].pivot.x;
    EXPECT_GT(joints[Joint::heading], 0.0);
    EXPECT_NEAR(joints[Joint::wheels_right] * assets::own_assets().wheel_radius,
                joints[Joint::heading] * half, 1e-9);
    EXPECT_EQ(joints[Joint::wheels_left], -joints[Joint::wheels_right]);
    EXPECT_EQ(simulation.state().x, 0.0);
    EXPECT_EQ(simulation.state().z, 0.0);
}

TEST(DrivingTest, RollsTheOuterSideFurtherInACurve)
{
    Simulation simulation(assets::own_assets());
    hold(simulation, {"drive_forward", "turn_right"}, 6);
    const tank::JointAngles& joints = simulation.state().joints;
    EXPECT_GT(joints[Joint::wheels_left], joints[Joint::wheels_right]);
    EXPECT_GT(joints[Joint::wheels_right], 0.0);
    EXPECT_LT(simulation.state().x, 0.0); // to its right
}

TEST(DrivingTest, StandsStillAtTheEdgeOfTheGround)
{
    Simulation simulation(assets::own_assets());
    simulation.open_link("z=199.9&heading=0");
    hold(simulation, {"drive_forward"}, TICKS_PER_SECOND);
    EXPECT_EQ(simulation.state().z, 200.0);
    const double wheels = simulation.state().joints[Joint::wheels_left];
    hold(simulation, {"drive_forward"}, 10);
    EXPECT_EQ(simulation.state().joints[Joint::wheels_left], wheels);
    hold(simulation, {"drive_backward"}, 10);
    EXPECT_LT(simulation.state().z, 200.0);
}

TEST(DrivingTest, LeavesTheWheelsToTheirOwnKeysWhileTheTankStands)
{
    Simulation simulation(assets::own_assets());
    hold(simulation, {"wheels_forward"}, 10);
    EXPECT_GT(simulation.state().joints[Joint::wheels_left], 0.0);
    EXPECT_EQ(simulation.state().x, 0.0);
    EXPECT_EQ(simulation.state().z, 0.0);
}

TEST(DrivingTest, CancelsWhenBothWaysAreHeldAtOneSpeed)
{
    Simulation simulation(assets::own_assets());
    hold(simulation, {"turn_left", "turn_right", "drive_forward", "drive_backward"}, 30);
    EXPECT_EQ(simulation.state().z, 0.0);
    EXPECT_EQ(simulation.state().joints[Joint::heading], 0.0);
    EXPECT_EQ(simulation.state().joints[Joint::wheels_left], 0.0);
}

} // namespace
} // namespace app
