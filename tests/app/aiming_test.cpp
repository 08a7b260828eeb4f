#include "app/commands/pointer.h"
#include "app/simulation/simulation.h"
#include "app/view/camera_view.h"
#include "fixtures.h"
#include "simulation_steps.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace app {
namespace {

TEST(AimingTest, AimingFiresFromTheEyeThroughThePlaceInTheWindow)
{
    Simulation simulation(assets::own_assets());
    for (glm::dvec2 aim : {glm::dvec2(0.0), glm::dvec2(0.3, -0.2), glm::dvec2(-0.5, 0.4)}) {
        open(simulation, "orbit=70&tilt=25&distance=30");
        simulation.apply("aim_x", aim.x);
        simulation.apply("aim_y", aim.y);
        const CameraView camera = camera_view(simulation.state(), simulation.assets());
        const ViewAxes axes = view_axes(camera);
        ASSERT_EQ(simulation.apply("fire_at_aim", 1.0).refusal, "");
        const Projectile& projectile = simulation.state().projectile;
        EXPECT_EQ(projectile.aim, glm::dvec2(0.0));
        EXPECT_LT(glm::distance(projectile.a, camera.eye), 0.001);
        const glm::dvec3 way = projectile.b - projectile.a;
        const double depth = glm::dot(way, axes.forward);
        EXPECT_NEAR(glm::dot(way, axes.right) / (depth * axes.heights_per_depth), aim.x, 2e-4);
        EXPECT_NEAR(glm::dot(way, axes.up) / (depth * axes.heights_per_depth), aim.y, 2e-4);
        EXPECT_TRUE(simulation.state().shot.flies);
    }
    open(simulation, "orbit=70&tilt=25&distance=30");
    simulation.apply("fire_at_aim", 1.0); // through the middle: at the tank
    steps(simulation, 300);
    EXPECT_GT(simulation.touches(), 0u);
    open(simulation, "x=200&orbit=90&tilt=0&distance=400");
    simulation.apply("aim_x", 4.0);
    EXPECT_NE(simulation.apply("fire_at_aim", 1.0).refusal, "");
    EXPECT_FALSE(simulation.state().shot.flies);
}

TEST(AimingTest, DraggingMovesTheHandleUnderThePointer)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "probe=point&point_x=1&orbit=30&distance=12");
    const CameraView camera = camera_view(simulation.state(), simulation.assets());
    const ViewAxes axes = view_axes(camera);
    const auto seen = [&] {
        const glm::dvec3 from_eye = simulation.state().projectile.point - camera.eye;
        const double height = glm::dot(from_eye, axes.forward) * axes.heights_per_depth;
        return glm::dvec3(glm::dot(from_eye, axes.right) / height, glm::dot(from_eye, axes.up) / height,
                          glm::dot(from_eye, axes.forward));
    };
    const glm::dvec3 start = seen();
    EXPECT_EQ(handle_at(simulation.state(), simulation.assets(), glm::dvec2(start) + glm::dvec2(0.01, 0.0)),
              Handle::point);
    EXPECT_FALSE(
        handle_at(simulation.state(), simulation.assets(), glm::dvec2(start) + glm::dvec2(0.1, 0.0)));
    simulation.apply("aim_x", start.x + 0.1);
    simulation.apply("aim_y", start.y + 0.05);
    ASSERT_EQ(simulation.apply("move_to_aim", 1.0).refusal, "");
    EXPECT_NEAR(seen().x, start.x + 0.1, 1e-4);
    EXPECT_NEAR(seen().y, start.y + 0.05, 1e-4);
    EXPECT_NEAR(seen().z, start.z, 1e-9);
    open(simulation, "probe=segment");
    EXPECT_FALSE(handle_at(simulation.state(), simulation.assets(), glm::dvec2(9.0)));
}

} // namespace
} // namespace app
