// What commands and ticks say has happened.
#include "app/state/outcome.h"

#include "app/simulation/simulation.h"
#include "assets/users_tank.h"
#include "fixtures.h"
#include "original_set.h"
#include "simulation_steps.h"

#include <gtest/gtest.h>

namespace app {
namespace {

Outcome steps_until(Simulation& simulation, int most, bool Outcome::* flag)
{
    Outcome outcome;
    for (int i = 0; i < most && !(outcome.*flag); ++i) {
        outcome = simulation.step();
    }
    return outcome;
}

bool has_changed(const Outcome& outcome, FieldId field)
{
    return outcome.fields.test(static_cast<std::size_t>(field));
}

TEST(OutcomeTest, NamesTheFieldsThatAreOthersAndNoMore)
{
    Simulation simulation(assets::own_assets());
    Outcome outcome = simulation.apply("wheels", 20.0);
    EXPECT_TRUE(has_changed(outcome, FieldId::wheels_left));
    EXPECT_TRUE(has_changed(outcome, FieldId::wheels_right));
    EXPECT_EQ(outcome.fields.count(), 2u);
    EXPECT_TRUE(simulation.apply("wheels", 20.0).fields.none());
    outcome = simulation.apply("reset_pose", 1.0);
    EXPECT_EQ(outcome.fields.count(), 2u);
    EXPECT_TRUE(simulation.apply("turret_left", 1.0).holds_changed);
    outcome = simulation.step();
    EXPECT_TRUE(has_changed(outcome, FieldId::turret));
    EXPECT_EQ(outcome.fields.count(), 1u);
}

TEST(OutcomeTest, ARefusalSaysWhyAndNothingHasHappened)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "view=four");
    const std::uint64_t revision = simulation.revision();
    const Outcome outcome = simulation.apply("fire_at_aim", 1.0);
    EXPECT_NE(outcome.refusal, "");
    EXPECT_FALSE(outcome.is_visible());
    EXPECT_FALSE(outcome.fired);
    EXPECT_EQ(simulation.revision(), revision);
}

TEST(OutcomeTest, FollowsAShotFromFiringOverItsHitToItsLanding)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "task=2.6&event=none");
    Outcome outcome = simulation.apply("fire", 1.0);
    EXPECT_TRUE(outcome.fired);
    EXPECT_TRUE(outcome.event_changed);
    EXPECT_FALSE(outcome.hit);
    EXPECT_TRUE(steps_until(simulation, 600, &Outcome::hit).hit);
    EXPECT_GT(simulation.touches(), 0u);
    EXPECT_TRUE(simulation.step().animated) << "its sparks fly";
    EXPECT_TRUE(steps_until(simulation, MAX_REPLAY_TICKS + 2, &Outcome::landed).landed);
    EXPECT_FALSE(simulation.state().shot.flies);
}

TEST(OutcomeTest, TellsOpeningsPrintsAndSwitchesOfTheLevel)
{
    Simulation simulation(assets::own_assets());
    EXPECT_TRUE(simulation.open_link("task=3.3").outcome.opened);
    EXPECT_TRUE(simulation.apply("next_task_1", 1.0).opened);
    EXPECT_TRUE(simulation.apply("print_report", 1.0).printed);
    EXPECT_FALSE(simulation.apply("print_report", 0.0).printed);
    open(simulation, "task=3.3");
    EXPECT_TRUE(simulation.apply("distance", 200.0).switched);
    EXPECT_FALSE(simulation.apply("distance", 201.0).switched);
}

TEST(OutcomeTest, TellsWhenAnotherTankIsShown)
{
    static const assets::Assets USERS =
        assets::read_users_tank(assets::original_set().views(), assets::PAINT_VIEW).value().assets;
    Simulation simulation(assets::own_assets());
    EXPECT_FALSE(simulation.apply("tank", 1).tank_replaced) << "there is none yet";
    EXPECT_TRUE(simulation.set_user_tank(&USERS).tank_replaced);
    EXPECT_TRUE(simulation.apply("tank", 0).tank_replaced);
    EXPECT_TRUE(simulation.open_link("tank=own").outcome.tank_replaced);
}

TEST(OutcomeTest, SumsUpSeveralWithTheLastRefusal)
{
    Outcome sum;
    sum |= Outcome{.hit = true};
    sum |= Outcome::refused("No.");
    EXPECT_TRUE(sum.hit);
    EXPECT_EQ(sum.refusal, "No.");
    sum |= Outcome{.opened = true};
    EXPECT_TRUE(sum.hit && sum.opened);
    EXPECT_EQ(sum.refusal, "No.");
}

} // namespace
} // namespace app
