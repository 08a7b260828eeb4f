// A simulation whose tank becomes another one while it runs.
#include "app/simulation/simulation.h"

#include "app/report/state_json.h"
#include "assets/users_tank.h"
#include "original_set.h"

#include <gtest/gtest.h>

namespace app {
namespace {

const assets::Assets& users_assets()
{
    static const assets::Assets ASSETS =
        assets::read_users_tank(assets::original_set().views(), assets::PAINT_VIEW).value().assets;
    return ASSETS;
}

bool spheres_are_of(const Simulation& simulation, const assets::Assets& assets)
{
    TankSpheres expected(assets);
    expected.refit(simulation.state());
    const collision::SphereHierarchy& spheres = simulation.spheres().hierarchy();
    for (std::size_t part = 0; part < tank::PART_COUNT; ++part) {
        if (spheres.parts()[part].radius != expected.hierarchy().parts()[part].radius ||
            spheres.parts()[part].centre != expected.hierarchy().parts()[part].centre) {
            return false;
        }
    }
    return true;
}

TEST(SimulationTankTest, ShowsTheUsersTankWhereTheStateAsksForItAndOursElsewhere)
{
    Simulation simulation(assets::own_assets());
    EXPECT_FALSE(simulation.has_own_tank());
    simulation.apply("turret", 30.0);
    simulation.set_user_tank(&users_assets());
    EXPECT_EQ(&simulation.assets(), &assets::own_assets()); // it was not asked for
    EXPECT_EQ(simulation.apply("tank", 1).refusal, "");
    EXPECT_EQ(&simulation.assets(), &users_assets());
    EXPECT_TRUE(spheres_are_of(simulation, users_assets()));
    EXPECT_EQ(link(simulation.state()), "turret=30&tank=own"); // the pose is kept
    simulation.apply("tank", 0);
    EXPECT_EQ(&simulation.assets(), &assets::own_assets());
    EXPECT_TRUE(spheres_are_of(simulation, assets::own_assets()));
}

TEST(SimulationTankTest, ALinkThatNeedsTheUsersFilesWaitsForThemWithItsStateKept)
{
    Simulation simulation(assets::own_assets());
    EXPECT_TRUE(simulation.open_link("turret=-20&tank=own&probe=point").messages.empty());
    EXPECT_TRUE(simulation.lacks_own_tank());
    EXPECT_EQ(&simulation.assets(), &assets::own_assets());
    const std::uint64_t revision = simulation.revision();
    simulation.set_user_tank(&users_assets());
    EXPECT_FALSE(simulation.lacks_own_tank());
    EXPECT_EQ(&simulation.assets(), &users_assets());
    EXPECT_TRUE(spheres_are_of(simulation, users_assets()));
    EXPECT_GT(simulation.revision(), revision);
    EXPECT_EQ(link(simulation.state()), "turret=-20&probe=point&tank=own");
}

TEST(SimulationTankTest, WhatALinkHasUnderWayGoesAsIfTheFilesHadBeenThere)
{
    constexpr const char* LINK = "tank=own&event=fire&tick=40&seed=7&point_x=0&point_y=2&point_z=9";
    Simulation late(assets::own_assets());
    late.open_link(LINK);
    late.set_user_tank(&users_assets());
    Simulation early(assets::own_assets());
    early.set_user_tank(&users_assets());
    early.open_link(LINK);
    EXPECT_EQ(late.hash(), early.hash());
    EXPECT_EQ(late.touches(), early.touches());
    EXPECT_EQ(link(late.state()), link(early.state()));
    // And it matters: on our tank the projectile meets other spheres, elsewhere, and the sparks still fly.
    Simulation lab(assets::own_assets());
    lab.open_link(std::string(LINK).substr(9));
    EXPECT_GT(early.touches(), 0u);
    EXPECT_NE(lab.sparks().hash(), early.sparks().hash());
}

TEST(SimulationTankTest, TellsTheFactorAndWhetherThereIsAUsersTank)
{
    Simulation simulation(assets::own_assets());
    EXPECT_NE(state_json(simulation).find("\"has_own_tank\":false"), std::string::npos);
    simulation.set_user_tank(&users_assets());
    simulation.apply("tank", 1);
    const std::string json = state_json(simulation);
    EXPECT_NE(json.find("\"has_own_tank\":true"), std::string::npos);
    EXPECT_NE(json.find("your own, scaled by 0.04369"), std::string::npos) << json;
    simulation.open_link("task=2.2&tank=own");
    EXPECT_NE(state_json(simulation).find("your own, scaled by 0.04369"), std::string::npos);
}

} // namespace
} // namespace app
