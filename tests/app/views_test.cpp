#include "app/commands/firing.h"
#include "app/commands/pointer.h"
#include "app/commands/update.h"
#include "app/links/links.h"
#include "app/simulation/simulation.h"
#include "app/state/fields.h"
#include "app/view/camera_view.h"
#include "app/view/frame.h"
#include "assets/users_tank.h"
#include "fixtures.h"
#include "original_set.h"
#include "tank/part_matrices.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace app {
namespace {

State state_of(std::string_view fragment)
{
    State state;
    EXPECT_TRUE(open_link(state, fragment).messages.empty()) << fragment;
    return state;
}

CameraView camera_of(const State& state)
{
    return camera_view(state, assets::own_assets());
}

/// Returns the way the tank heads.
glm::dvec3 ahead(const State& state)
{
    const double heading = state.joints[tank::Joint::heading];
    return {std::sin(heading), 0.0, std::cos(heading)};
}

glm::dvec3 forward_of(const CameraView& camera)
{
    return glm::normalize(camera.centre - camera.eye);
}

/// Returns how far apart two angles are on the circle. Radians.
double between(double one, double other)
{
    return std::abs(std::remainder(one - other, 2.0 * std::numbers::pi));
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance)
{
    EXPECT_NEAR(glm::distance(actual, expected), 0.0, tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z;
}

void hold(State& state, std::string_view command, int ticks)
{
    ASSERT_EQ(apply(state, assets::own_assets(), command, 1.0).refusal, "");
    for (int tick = 0; tick < ticks; ++tick) {
        step(state, assets::own_assets());
    }
    ASSERT_EQ(apply(state, assets::own_assets(), command, 0.0).refusal, "");
}

TEST(Views, FollowLooksFromBehindWhereverTheTankHeads)
{
    for (const char* link : {"view=follow", "view=follow&heading=120&x=7&z=-3", "view=follow&heading=-180"}) {
        const State state = state_of(link);
        const CameraView camera = camera_of(state);
        const glm::dvec3 forward = forward_of(camera);
        EXPECT_GT(glm::dot(forward, ahead(state)), 0.8) << link;
        const glm::dvec3 tank(state.x, 0.0, state.z);
        EXPECT_NEAR(glm::cross(ahead(state), camera.eye - tank).y, 0.0, 1e-9) << link;
        EXPECT_LT(glm::dot(camera.eye - tank, ahead(state)), -5.0) << link;
    }
}

TEST(Views, FollowLagsBehindATurnSmoothlyAndSwingsBack)
{
    State state = state_of("view=follow");
    const auto direction = [&] {
        const glm::dvec3 forward = forward_of(camera_of(state));
        return std::atan2(forward.x, forward.z);
    };
    ASSERT_EQ(apply(state, assets::own_assets(), "turn_left", 1.0).refusal, "");
    double last = direction();
    double last_rate = 0.0;
    for (int tick = 0; tick < 60; ++tick) {
        step(state, assets::own_assets());
        const double rate = between(direction(), last);
        EXPECT_NEAR(rate, last_rate, 0.002); // the picture neither starts nor stops with a jerk
        last_rate = rate;
        last = direction();
    }
    ASSERT_EQ(apply(state, assets::own_assets(), "turn_left", 0.0).refusal, "");
    EXPECT_GT(between(direction(), state.joints[tank::Joint::heading]), 0.1);
    for (int tick = 0; tick < 600; ++tick) {
        step(state, assets::own_assets());
    }
    EXPECT_NEAR(between(direction(), state.joints[tank::Joint::heading]), 0.0, 1e-9);
    EXPECT_FALSE(step(state, assets::own_assets()).is_visible()); // nothing is drawn again
}

TEST(Views, FollowLooksRoundTheTankByTheKeysThatGoRoundIt)
{
    State state = state_of("view=follow");
    const double orbit = state.camera.orbit;
    hold(state, "orbit_right", 30);
    EXPECT_NEAR(state.camera.chase, std::numbers::pi / 6.0, 1e-9);
    EXPECT_EQ(state.camera.orbit, orbit);
}

TEST(Views, TheGunnerLooksAlongTheBarrelFromAboveTheRoof)
{
    for (const char* link : {"view=gunner", "view=gunner&heading=70&turret=-130&gun=20&x=3&z=9",
                             "view=gunner&turret=30&gun=-9"}) {
        const State state = state_of(link);
        const CameraView camera = camera_of(state);
        const tank::PartMatrices matrices =
            tank::part_matrices(assets::own_assets().layout, {{state.x, 0.0, state.z}}, state.joints);
        const glm::dvec3 barrel(glm::dmat4(matrices.joint(tank::Part::main_gun))[2]);
        expect_near(forward_of(camera), barrel, 1e-6);
        const glm::dvec3 turret(glm::dmat4(matrices.joint(tank::Part::turret))[3]);
        EXPECT_LT(glm::distance(camera.eye, turret), 2.0) << link;
        EXPECT_GT(camera.eye.y - turret.y, 0.7) << link; // the roof is 0.78 m above its ring
        EXPECT_LT(camera.eye.y - turret.y, 1.3) << link;
    }
}

TEST(Views, TheGunnerOfAnyTankLooksOutAboveItsRoofAndBesideItsBarrel)
{
    for (const float stretch : {1.0f, 1.5f}) { // the lab's own, and one that nobody knows
        const assets::Files files = assets::original_set({.turret_stretch = stretch});
        const base::Result<assets::UsersTank> tank =
            assets::read_users_tank(files.views(), assets::PAINT_VIEW);
        ASSERT_TRUE(tank);
        const assets::Assets& assets = tank.value().assets;
        const State state = state_of("view=gunner&turret=25&gun=3");
        const CameraView camera = camera_view(state, assets);
        const tank::PartMatrices matrices = tank::part_matrices(assets.layout, {}, state.joints);
        const glm::dmat4 turret(matrices.joint(tank::Part::turret));
        const glm::dmat4 gun(matrices.joint(tank::Part::main_gun));
        expect_near(forward_of(camera), glm::dvec3(gun[2]), 1e-6);
        // The made turret's roof, in metres above its mesh's origin; its antennas do not count.
        const double roof = assets.scale * static_cast<double>(assets::MADE_ROOF);
        const double mesh_y =
            turret[3].y + static_cast<double>(assets.layout[tank::Part::turret].mesh_offset.y);
        EXPECT_NEAR(camera.eye.y, mesh_y + roof, 0.2);
        const glm::dvec3 from_trunnion = camera.eye - glm::dvec3(gun[3]);
        EXPECT_LT(glm::dot(from_trunnion, glm::dvec3(gun[0])), -0.3); // to the right of the barrel
        EXPECT_GT(assets.muzzle.z, 3.0f);
        EXPECT_LT(glm::length(glm::dvec2(assets.muzzle)), 0.5);
    }
}

TEST(Views, TheGunnersKeysAndDragsTurnTurretAndGunWithinTheirLimits)
{
    State state = state_of("view=gunner");
    hold(state, "orbit_left", 60);
    EXPECT_GT(state.joints[tank::Joint::turret], 0.1); // to the left
    hold(state, "tilt_up", 6000);
    EXPECT_EQ(state.joints[tank::Joint::main_gun], tank::joint_limits(tank::Joint::main_gun).maximum);
    const double turret = state.joints[tank::Joint::turret];
    ASSERT_EQ(apply(state, assets::own_assets(), "orbit_by", -10.0).refusal, ""); // a drag to the right
    EXPECT_GT(state.joints[tank::Joint::turret], turret);
    EXPECT_EQ(state.camera.orbit, State().camera.orbit);
    EXPECT_EQ(state.camera.tilt, State().camera.tilt);
}

TEST(Views, TheGunnerShootsWhereHeLooks)
{
    for (const char* link : {"view=gunner", "view=gunner&turret=50&gun=12&heading=20"}) {
        for (const char* command : {"fire", "fire_at_aim"}) {
            State state = state_of(link);
            const CameraView camera = camera_of(state);
            ASSERT_EQ(apply(state, assets::own_assets(), command, 1.0).refusal, "");
            ASSERT_TRUE(state.shot.flies);
            const tank::PartMatrices matrices =
                tank::part_matrices(assets::own_assets().layout, {}, state.joints);
            const glm::dvec3 trunnion(glm::dmat4(matrices.joint(tank::Part::main_gun))[3]);
            EXPECT_NEAR(glm::distance(state.shot.origin, trunnion), 5.4, 0.2); // from the muzzle
            // Far away it crosses what the middle of the sight shows.
            const glm::dvec3 direction = glm::normalize(state.shot.velocity);
            const glm::dvec3 from_eye = state.shot.origin + 195.0 * direction - camera.eye;
            EXPECT_NEAR(glm::dot(glm::normalize(from_eye), forward_of(camera)), 1.0, 1e-5) << command;
        }
    }
}

TEST(Views, AShotOfTheGunnerTouchesNoPartOfTheTank)
{
    Simulation simulation(assets::own_assets());
    simulation.open_link("view=gunner&speed=40");
    ASSERT_EQ(simulation.apply("fire", 1.0).refusal, "");
    for (int tick = 0; tick < 120; ++tick) {
        simulation.step();
    }
    EXPECT_EQ(simulation.touches(), 0u);
}

TEST(Views, TheGunnersTankIsTheHighOneHoweverFarTheOtherViewsAre)
{
    EXPECT_EQ(make_frame(state_of("view=gunner&distance=400"), assets::own_assets()).tanks[0].level,
              lod::Level::high);
    EXPECT_EQ(make_frame(state_of("view=orbit&distance=400"), assets::own_assets()).tanks[0].level,
              lod::Level::low);
}

TEST(Views, FourShowTheFrontTheLeftSideTheTopAndWhatOrbitShows)
{
    const State state = state_of("view=four&heading=35&x=4");
    const Frame frame = make_frame(state, assets::own_assets());
    ASSERT_EQ(frame.panes.size(), 4u);
    const glm::dvec3 left(ahead(state).z, 0.0, -ahead(state).x);
    const std::span<const PaneInFrame> panes = frame.panes;
    expect_near(forward_of(panes[0].camera), -ahead(state), 1e-9);
    expect_near(forward_of(panes[1].camera), -left, 1e-9);
    expect_near(forward_of(panes[2].camera), {0.0, -1.0, 0.0}, 1e-9);
    // From the left and from above the gun points to the same side of the picture.
    expect_near(view_axes(panes[1].camera).right, -ahead(state), 1e-9);
    expect_near(view_axes(panes[2].camera).right, -ahead(state), 1e-9);
    expect_near(panes[3].camera.eye, camera_of(state_of("heading=35&x=4")).eye, 1e-9);
    for (const PaneInFrame& pane : panes) { // all at one scale
        const double height = 2.0 * glm::distance(pane.camera.eye, pane.camera.centre) *
                              std::tan(0.5 * pane.camera.field_of_view);
        EXPECT_NEAR(height, 2.0 * state.camera.distance * std::tan(std::numbers::pi / 8.0), 1e-9);
    }
    EXPECT_EQ(make_frame(state_of("view=follow"), assets::own_assets()).panes.size(), 1u);
}

TEST(Views, FourHaveNoAim)
{
    Simulation simulation(assets::own_assets());
    simulation.open_link("view=four&probe=point");
    const State before = simulation.state();
    EXPECT_EQ(simulation.apply("fire_at_aim", 1.0).refusal, NO_AIM_IN_FOUR_VIEWS);
    EXPECT_EQ(simulation.apply("move_to_aim", 1.0).refusal, NO_AIM_IN_FOUR_VIEWS);
    EXPECT_EQ(simulation.state(), before);
    EXPECT_EQ(handle_at(simulation.state(), assets::own_assets(), {}), std::nullopt);
    EXPECT_EQ(simulation.apply("fire", 1.0).refusal, "");
}

TEST(Views, ALinkGivesTheEyeBackWhereItWas)
{
    Simulation simulation(assets::own_assets());
    simulation.open_link("view=follow&task=2.6");
    simulation.apply("turn_left", 1.0);
    for (int tick = 0; tick < 20; ++tick) {
        simulation.step();
    }
    simulation.apply("turn_left", 0.0);
    simulation.apply("fire", 1.0);
    for (int tick = 0; tick < 10; ++tick) {
        simulation.step();
    }
    const State shared = snapped(simulation.state());
    Simulation opened(assets::own_assets());
    opened.open_link(link(simulation.state()));
    EXPECT_NE(shared.camera.chase, 0.0);
    EXPECT_NE(opened.state().event.kind, EventKind::none); // which is replayed, without moving the eye
    EXPECT_EQ(opened.state().camera, shared.camera);
    expect_near(opened.frame().camera.eye, camera_of(shared).eye, 1e-12);
}

TEST(Views, TheEyeIsAboveTheGroundInAll)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 2000; ++i) {
        const State state = random_state(random);
        const Frame frame = make_frame(state, assets::own_assets());
        for (const PaneInFrame& pane : frame.panes) {
            EXPECT_GT(pane.camera.eye.y, 0.0) << link(state);
            EXPECT_LT(pane.camera.near_plane, pane.camera.far_plane);
        }
    }
}

TEST(Views, NarrowWindowsShowMoreFromBottomToTop)
{
    EXPECT_EQ(vertical_fov_scale(1.6), 1.0);
    EXPECT_EQ(vertical_fov_scale(1.25), 1.0);
    EXPECT_NEAR(vertical_fov_scale(0.625), 2.0, 1e-12);
}

} // namespace
} // namespace app
