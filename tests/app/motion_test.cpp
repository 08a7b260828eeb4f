#include "app/simulation/motion.h"

#include "app/report/state_json.h"
#include "app/simulation/simulation.h"
#include "fixtures.h"

#include <gtest/gtest.h>

namespace app {
namespace {

using tank::Part;

class MotionTest : public ::testing::Test
{
protected:
    void step(int ticks)
    {
        for (int tick = 0; tick < ticks; ++tick) {
            simulation.step();
        }
    }

    bool moves(Part part) const { return simulation.moving_parts().contains(tank::index_of(part)); }

    bool rests() const { return simulation.moving_parts().is_empty(); }

    Simulation simulation{assets::own_assets()};
};

TEST_F(MotionTest, IsOfThePartWhoseJointTurnsAndNotOfWhatItCarries)
{
    EXPECT_TRUE(rests());
    simulation.apply("turret_left", 1.0);
    step(5);
    EXPECT_TRUE(moves(Part::turret));
    EXPECT_FALSE(moves(Part::main_gun));
    EXPECT_FALSE(moves(Part::body));
    simulation.apply("wheels_forward", 1.0);
    step(5);
    for (Part wheel : {Part::wheel_left_1, Part::wheel_left_7, Part::wheel_right_4}) {
        EXPECT_TRUE(moves(wheel));
    }
}

TEST_F(MotionTest, EndsSoonAfterTheKeyIsLetGoAndIsDrawnOnceMore)
{
    simulation.apply("gun_up", 1.0);
    step(5);
    simulation.apply("gun_up", 0.0);
    EXPECT_TRUE(moves(Part::main_gun));
    int ticks = 0;
    std::uint64_t before = 0;
    for (; ticks < 60 && !rests(); ++ticks) {
        before = simulation.revision();
        step(1);
    }
    EXPECT_GT(ticks, 5); // a drag comes in jumps
    EXPECT_LT(ticks, 30);
    EXPECT_GT(simulation.revision(), before); // the page is told
    const std::uint64_t at_rest = simulation.revision();
    step(60);
    EXPECT_EQ(simulation.revision(), at_rest);
}

TEST_F(MotionTest, EndsAtALimit)
{
    simulation.apply("gun_up", 1.0);
    step(600);
    EXPECT_TRUE(rests()); // though the key is held
}

TEST_F(MotionTest, OfASliderIsSeen)
{
    simulation.apply("secondary_gun", 20.0);
    EXPECT_TRUE(moves(Part::secondary_gun));
    step(60);
    EXPECT_TRUE(rests());
}

TEST_F(MotionTest, OfTheTankIsItsBodysAndItsWheels)
{
    simulation.apply("drive_forward", 1.0);
    step(5);
    EXPECT_TRUE(moves(Part::body));
    EXPECT_TRUE(moves(Part::wheel_right_2));
    EXPECT_FALSE(moves(Part::turret));
}

TEST_F(MotionTest, IsNoneOfALinkThatIsOpened)
{
    simulation.apply("turret", 20.0);
    simulation.open_link("turret=90&heading=10");
    EXPECT_TRUE(rests());
}

TEST_F(MotionTest, ShowsItsAxisWhenThatIsAskedFor)
{
    simulation.open_link("axis=moving");
    EXPECT_FALSE(simulation.frame().axis.is_shown);
    simulation.apply("turret_left", 1.0);
    simulation.apply("gun_up", 1.0);
    step(3);
    // Of two the one further out.
    const AxisInFrame axis = simulation.frame().axis;
    const AxisInFrame gun = axis_of(simulation.state(), assets::own_assets(), tank::Joint::main_gun);
    EXPECT_TRUE(axis.is_shown);
    EXPECT_EQ(axis.origin, gun.origin);
    EXPECT_EQ(axis.direction, gun.direction);
    simulation.open_link("axis=off");
    simulation.apply("turret_left", 1.0);
    step(3);
    EXPECT_FALSE(simulation.frame().axis.is_shown);
}

TEST_F(MotionTest, OfAPartWithTwoJointsShowsTheAxisOfTheOneThatMoves)
{
    simulation.open_link("axis=moving&secondary_gun=50");
    simulation.apply("secondary_gun_left", 1.0);
    step(3);
    EXPECT_TRUE(moves(Part::secondary_gun));
    EXPECT_NEAR(simulation.frame().axis.direction.y, 1.0, 1e-6);
    simulation.apply("secondary_gun_up", 1.0);
    step(3);
    EXPECT_NEAR(simulation.frame().axis.direction.y, 0.0, 1e-6); // both move: the inner one
    simulation.apply("release_all", 1.0);
    step(60);
    simulation.apply("secondary_gun_down", 1.0);
    step(3);
    EXPECT_TRUE(moves(Part::secondary_gun));
    EXPECT_NEAR(simulation.frame().axis.direction.y, 0.0, 1e-6);
}

TEST_F(MotionTest, IsToldToThePage)
{
    EXPECT_NE(state_json(simulation).find("\"moving\":[]"), std::string::npos);
    simulation.apply("turret_left", 1.0);
    step(1);
    EXPECT_NE(state_json(simulation).find("\"moving\":[\"turret\"]"), std::string::npos);
}

} // namespace
} // namespace app
