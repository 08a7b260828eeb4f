#include "app/commands/firing.h"
#include "app/state/flight.h"

#include "allocation_count/allocation_count.h"
#include "app/commands/update.h"
#include "app/links/tasks.h"
#include "app/simulation/simulation.h"
#include "fixtures.h"
#include "simulation_steps.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace app {
namespace {

constexpr std::string_view ACROSS = "line_ax=20&line_ay=2.4&line_az=1&line_bx=19&line_by=2.4&line_bz=1";

TEST(FiringTest, TheProjectileFliesAlongItsLineAtItsSpeed)
{
    Simulation simulation(assets::own_assets());
    open(simulation, std::string(ACROSS) + "&speed=12");
    EXPECT_FALSE(simulation.state().shot.flies);
    EXPECT_EQ(simulation.apply("fire", 1.0).refusal, "");
    for (int tick = 0; tick < 50; ++tick) {
        ASSERT_TRUE(simulation.state().shot.flies);
        const glm::dvec3 expected(20.0 - 12.0 * tick / 60.0, 2.4, 1.0);
        ASSERT_LT(glm::distance(position_of(simulation.state().shot), expected), 1e-9);
        ASSERT_EQ(simulation.frame().shot.position, position_of(simulation.state().shot));
        simulation.step();
    }
}

TEST(FiringTest, AShotEndsByItselfAndEverythingIsAsBefore)
{
    Simulation simulation(assets::own_assets());
    open(simulation, std::string(ACROSS) + "&speed=2000");
    const State start = simulation.state();
    simulation.apply("fire", 1.0);
    steps(simulation, 200);
    State end = simulation.state();
    EXPECT_FALSE(end.shot.flies);
    EXPECT_EQ(end.event.kind, EventKind::none);
    EXPECT_FALSE(simulation.sparks().is_active());
    end.tick = start.tick;
    end.seed = start.seed;
    EXPECT_EQ(end, start);
    const std::uint64_t revision = simulation.revision();
    steps(simulation, 100);
    EXPECT_EQ(simulation.revision(), revision);
    EXPECT_EQ(link(simulation.state()), link(start));
}

TEST(FiringTest, ALineOfNoLengthIsNotFiredAlong)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "line_ax=1&line_ay=1&line_az=1&line_bx=1&line_by=1&line_bz=1");
    const State before = simulation.state();
    EXPECT_EQ(simulation.apply("fire", 1.0).refusal,
              "Both ends of the line are the same, so there is no direction to fire in.");
    EXPECT_EQ(simulation.state(), before);
    const LinkResult result =
        simulation.open_link("line_ax=1&line_ay=1&line_az=1&line_bx=1&line_by=1&line_bz=1&event=fire&tick=5");
    EXPECT_EQ(result.messages.size(), 1u);
    EXPECT_EQ(simulation.state(), before);
}

TEST(FiringTest, EveryPartOnTheWayIsTouchedExactlyOnceAtAnySpeed)
{
    Simulation simulation(assets::own_assets());
    open(simulation, ACROSS);
    const collision::PartSet on_the_way =
        simulation.spheres()
            .hierarchy()
            .hit_test(collision::Query::ray({20.0, 2.4, 1.0}, {-1.0, 0.0, 0.0}))
            .parts;
    ASSERT_GE(on_the_way.count(), 2);
    for (double speed : {3.0, 17.3, 60.0, 333.3, 1000.0, 2400.0, 5000.0}) {
        open(simulation, ACROSS);
        simulation.apply("speed", speed);
        simulation.apply("fire", 1.0);
        std::uint64_t sparks = 0;
        for (int i = 0; i < 1000; ++i) {
            simulation.step();
            sparks = std::max(sparks, simulation.sparks().systems()[0]->counts().released +
                                          simulation.sparks().systems()[0]->counts().refused);
        }
        EXPECT_EQ(simulation.touches(), static_cast<std::uint64_t>(on_the_way.count())) << speed;
        EXPECT_EQ(sparks, 100u * static_cast<std::uint64_t>(on_the_way.count())) << speed;
        EXPECT_TRUE(simulation.inside().is_empty());
    }
}

TEST(FiringTest, RandomShotsTouchWhatTheirWholeWayTouches)
{
    Simulation simulation(assets::own_assets());
    std::mt19937_64 random(61);
    const auto between = [&](double low, double high) { return low + (high - low) * next_unit(random); };
    for (int i = 0; i < 300; ++i) {
        open(simulation, "");
        simulation.apply("turret", between(-180.0, 180.0));
        for (std::string_view name : {"line_ax", "line_az"}) {
            simulation.apply(name, between(-12.0, 12.0));
        }
        simulation.apply("line_ay", between(0.0, 6.0));
        for (std::string_view name : {"line_bx", "line_bz"}) {
            simulation.apply(name, between(-3.0, 3.0));
        }
        simulation.apply("line_by", between(0.0, 4.0));
        simulation.apply("speed", between(100.0, 5000.0));
        ASSERT_EQ(simulation.apply("fire", 1.0).refusal, "");
        const State fired = simulation.state();
        glm::dvec3 end = fired.shot.origin;
        while (simulation.state().shot.flies) {
            end = position_of(simulation.state().shot);
            simulation.step();
        }
        const collision::PartSet expected = simulation.spheres()
                                                .hierarchy()
                                                .hit_test(collision::Query::segment(fired.shot.origin, end))
                                                .parts;
        ASSERT_EQ(simulation.touches(), static_cast<std::uint64_t>(expected.count())) << link(fired);
    }
}

TEST(FiringTest, AShowerFallsWhileTheProjectileStaysInsideAndEndsAfterwards)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "probe=point&point_x=30&point_y=2.4&point_z=1");
    steps(simulation, 10);
    EXPECT_FALSE(simulation.sparks().is_active());
    simulation.apply("point_x", 1.0);
    steps(simulation, 1);
    const std::uint64_t touched = simulation.touches();
    EXPECT_GE(touched, 1u);
    EXPECT_FALSE(simulation.inside().is_empty());
    steps(simulation, 300);
    EXPECT_EQ(simulation.touches(), touched);
    const auto systems = simulation.sparks().systems();
    EXPECT_EQ(systems[0]->live(), 0u); // the burst has burnt out
    EXPECT_GT(systems[1]->live(), 0u); // the shower goes on
    simulation.apply("point_x", 30.0);
    steps(simulation, 60);
    EXPECT_FALSE(simulation.sparks().is_active());
    EXPECT_TRUE(simulation.frame().particles.empty());
}

TEST(FiringTest, SparksStartWhereTheSphereIsTouchedAndNeverFallThroughTheGround)
{
    Simulation simulation(assets::own_assets());
    open(simulation, std::string(ACROSS) + "&speed=600");
    simulation.apply("fire", 1.0);
    while (simulation.touches() == 0) {
        simulation.step();
    }
    const std::string& text = simulation.log().lines().back().text;
    EXPECT_NE(text.find("The projectile touches "), std::string::npos) << text;
    bool any = false;
    for (int tick = 0; tick < 60; ++tick) {
        const Frame frame = simulation.frame();
        for (const particles::ParticleView& view : frame.particles) {
            for (std::size_t i = 0; i < view.count(); ++i) {
                any = true;
                ASSERT_GE(view.position(i).y, -1e-4F);
                ASSERT_LT(glm::length(glm::dvec3(view.position(i))), 15.0);
            }
        }
        simulation.step();
    }
    EXPECT_TRUE(any);
}

TEST(FiringTest, ALinkOfAShotInFlightReplaysItToTheSameHash)
{
    for (std::string_view base : {"", "speed=40&turret=33.33&probe=point&point_x=1", "task=2.6", "task=1.1",
                                  "particles=fountain&amount=200&speed=30"}) {
        for (int tick : {0, 1, 7, 31, 60, 90}) {
            Simulation live(assets::own_assets());
            open(live, base);
            live.apply("gun_up", 1.0);
            steps(live, 13); // off the grid
            live.apply("gun_up", 0.0);
            live.apply("fire", 1.0);
            steps(live, tick);
            live.apply("orbit", 77.0); // looking changes nothing
            const std::string text = link(live.state());
            EXPECT_EQ(live.state().event.kind, EventKind::fire) << base;
            Simulation replayed(assets::own_assets());
            steps(replayed, 5);
            open(replayed, text);
            EXPECT_EQ(link(replayed.state()), text);
            EXPECT_EQ(replayed.state(), snapped(live.state())) << text;
            EXPECT_EQ(replayed.inside(), live.inside()) << text;
            EXPECT_EQ(replayed.touches(), live.touches()) << text;
            EXPECT_EQ(replayed.sparks().hash(), live.sparks().hash()) << text;
            State opened;
            open_link(opened, text);
            EXPECT_EQ(opened, replayed.state()) << text; // with and without a simulation
            // And both go on alike.
            steps(replayed, 20);
            steps(live, 20);
            EXPECT_EQ(replayed.sparks().hash(), live.sparks().hash()) << text;
            EXPECT_EQ(replayed.state().shot, live.state().shot);
        }
    }
}

TEST(FiringTest, AnOpenedAnimationReplaysToTheSameHash)
{
    constexpr std::string_view BASE = "probe=point&point_x=1&point_y=2.4&point_z=1&particles=box&event=open";
    Simulation live(assets::own_assets());
    open(live, BASE);
    steps(live, 100);
    const std::string text = link(live.state());
    EXPECT_NE(text.find("&event=open&tick=100"), std::string::npos) << text;
    Simulation replayed(assets::own_assets());
    open(replayed, text);
    EXPECT_EQ(replayed.hash(), live.hash());
    EXPECT_GT(replayed.touches(), 0u);
    live.apply("turret", 5.0); // what was under way cannot be replayed from here
    EXPECT_EQ(link(live.state()).find("event"), std::string::npos);
    steps(replayed, 3600);
    EXPECT_EQ(replayed.state().event.kind, EventKind::none);
}

TEST(FiringTest, SameCommandsGiveTheSameHashWhateverTheFrames)
{
    const auto play = [](bool draws) {
        Simulation simulation(assets::own_assets());
        open(simulation, "task=2.6&particles=explosion");
        for (int i = 0; i < 100; ++i) {
            if (i % 30 == 10) {
                simulation.apply("fire", 1.0);
            }
            simulation.step();
            if (draws) {
                simulation.frame();
            }
        }
        return simulation.hash();
    };
    EXPECT_EQ(play(false), play(true));
}

TEST(FiringTest, BadEventsInLinksAreNamed)
{
    State state;
    EXPECT_EQ(open_link(state, "event=bang").messages.size(), 1u);
    EXPECT_EQ(state, State());
    EXPECT_EQ(open_link(state, "event=fire&tick=99999").messages.size(), 1u); // clamped
    EXPECT_EQ(open_link(state, "event=fire&tick=-1").messages.size(), 1u);
    EXPECT_EQ(open_link(state, "event=fire&seed=0").messages.size(), 1u);
    EXPECT_EQ(open_link(state, "event=fire&seed=x&tick=").messages.size(), 2u);
    EXPECT_TRUE(open_link(state, "tick=7").messages.empty());
    EXPECT_EQ(link(state), "event=open&tick=7");
    EXPECT_TRUE(open_link(state, "task=2.6&event=none").messages.empty());
    EXPECT_EQ(link(state), "task=2.6&event=none");
    EXPECT_FALSE(state.shot.flies);
}

TEST(FiringTest, HitsSparksAndJointsGoOnAtEitherLevel)
{
    Simulation high(assets::own_assets());
    Simulation low(assets::own_assets());
    open(high, "task=2.6&detail=high");
    open(low, "task=2.6&detail=low");
    for (int i = 0; i < 90; ++i) {
        high.step();
        low.step();
        ASSERT_EQ(high.inside(), low.inside());
        ASSERT_EQ(high.sparks().hash(), low.sparks().hash());
    }
    EXPECT_GT(low.touches(), 0u);
}

TEST(FiringTest, EveryPresetWithAnyAmountIsShownAndEnds)
{
    Simulation simulation(assets::own_assets());
    const std::span<const std::string_view> presets = field(FieldId::particles).choices;
    ASSERT_EQ(presets.size(), 9u); // none, Lab 2's six, and the two of hits
    for (std::size_t preset = 1; preset < presets.size(); ++preset) {
        for (double amount : {0.0, 1.0, 500.0, 1e6}) {
            open(simulation, "");
            simulation.apply("amount", amount);
            simulation.apply("particles", static_cast<double>(preset));
            EXPECT_EQ(simulation.shown_particles().capacity(), static_cast<std::size_t>(amount))
                << presets[preset];
            steps(simulation, 3);
            EXPECT_EQ(simulation.frame().particles.empty(), amount == 0.0) << presets[preset];
        }
        simulation.apply("particles", 0.0);
        steps(simulation, 1);
        EXPECT_FALSE(simulation.shown_particles().is_active());
    }
}

TEST(FiringTest, AStepAllocatesNothingWhileShotSparksAndParticlesAreUnderWay)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "task=2.6&particles=box&probe=point&point_x=1");
    steps(simulation, 120);
    simulation.apply("speed", 1.0);
    simulation.apply("fire", 1.0);
    steps(simulation, 1);
    ASSERT_TRUE(simulation.state().shot.flies);
    const std::size_t before = allocation_count();
    steps(simulation, 100);
    simulation.frame();
    EXPECT_EQ(allocation_count(), before);
    open(simulation, "");
    simulation.apply("turret_left", 1.0); // spheres follow
    steps(simulation, 1);
    const std::size_t turning = allocation_count();
    steps(simulation, 100);
    EXPECT_EQ(allocation_count(), turning);
}

TEST(FiringTest, DigitsOpenEveryTaskAndFigure)
{
    Simulation simulation(assets::own_assets());
    std::size_t opened = 0;
    for (Key key : {Key::digit_1, Key::digit_2, Key::digit_3, Key::digit_4}) {
        const Command* command = command_for_key(key);
        ASSERT_NE(command, nullptr);
        std::vector<bool> seen(tasks().size(), false);
        for (std::size_t i = 0; i < tasks().size(); ++i) {
            ASSERT_EQ(simulation.apply(*command, 1.0).refusal, "");
            ASSERT_TRUE(simulation.state().task);
            const std::size_t row = *simulation.state().task;
            opened += seen[row] ? 0u : 1u;
            seen[row] = true;
            ASSERT_EQ(simulation.state(), starting_state(row)) << tasks()[row].id;
        }
    }
    EXPECT_EQ(opened, tasks().size());
}

} // namespace
} // namespace app
