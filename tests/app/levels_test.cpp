#include "app/simulation/simulation.h"
#include "fixtures.h"
#include "simulation_steps.h"

#include <gtest/gtest.h>

namespace app {
namespace {

TEST(LevelsTest, LevelsSwitchExactlyOnceACrossing)
{
    Simulation simulation(assets::own_assets());
    std::mt19937_64 random(67);
    for (double speed : {0.01, 0.7, 5.0, 40.0}) {
        open(simulation, "distance=40&threshold=60");
        EXPECT_EQ(simulation.frame().tanks[0].level, lod::Level::high);
        for (double distance = 40.0; distance < 90.0; distance += speed) {
            simulation.apply("distance", distance + 0.3 * (next_unit(random) - 0.5));
            simulation.step();
        }
        simulation.apply("distance", 90.0);
        EXPECT_EQ(simulation.level_switches(), 1u) << speed;
        EXPECT_EQ(simulation.frame().tanks[0].level, lod::Level::low);
        for (double distance = 90.0; distance > 40.0; distance -= speed) {
            simulation.apply("distance", distance);
            simulation.step();
        }
        simulation.apply("distance", 40.0);
        EXPECT_EQ(simulation.level_switches(), 2u) << speed;
        EXPECT_EQ(simulation.frame().tanks[0].level, lod::Level::high);
    }
    open(simulation, "distance=61&threshold=60"); // within the band a link shows the far side of d as low
    EXPECT_EQ(simulation.frame().tanks[0].level, lod::Level::low);
    open(simulation, "distance=80&detail=high");
    EXPECT_EQ(simulation.frame().tanks[0].level, lod::Level::high);
    open(simulation, "distance=20&detail=low");
    EXPECT_EQ(simulation.frame().tanks[0].level, lod::Level::low);
}

TEST(LevelsTest, NotingTheThresholdMakesThisDistanceIt)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "distance=123.456");
    simulation.apply("note_threshold", 1.0);
    EXPECT_EQ(simulation.state().show.threshold, 123.456);
}

} // namespace
} // namespace app
