#include "app/view/frame.h"

#include "app/links/links.h"
#include "app/state/fields.h"
#include "fixtures.h"
#include "tank/part_matrices.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <type_traits>

namespace app {
namespace {

static_assert(std::is_trivially_copyable_v<Frame>);

Frame frame_of(std::string_view fragment)
{
    State state;
    EXPECT_TRUE(open_link(state, fragment).messages.empty()) << fragment;
    return make_frame(state, assets::tiny_assets());
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected)
{
    EXPECT_NEAR(actual.x, expected.x, 1e-9);
    EXPECT_NEAR(actual.y, expected.y, 1e-9);
    EXPECT_NEAR(actual.z, expected.z, 1e-9);
}

/// Returns where a point is in the window, each coordinate in [-1, 1] if it is seen.
glm::dvec3 in_window(const CameraView& camera, double aspect, const glm::dvec3& point)
{
    const glm::dmat4 projection =
        glm::perspective(camera.field_of_view, aspect, camera.near_plane, camera.far_plane);
    const glm::dvec4 clip =
        projection * glm::lookAt(camera.eye, camera.centre, camera.up) * glm::dvec4(point, 1.0);
    return glm::dvec3(clip) / clip.w;
}

TEST(FrameTest, OrbitZeroLooksAlongMinusZFromTheFront)
{
    const CameraView camera = frame_of("orbit=0&tilt=0&distance=20&look_x=0&look_y=1&look_z=0").camera;
    expect_near(camera.eye, {0, 1, 20});
    expect_near(camera.centre, {0, 1, 0});
    EXPECT_NEAR(camera.field_of_view, std::numbers::pi / 4.0, 1e-15);
}

TEST(FrameTest, OrbitGoesToTheLeftOfTheTankAndTiltUp)
{
    expect_near(frame_of("orbit=90&tilt=0&distance=20&look_y=1&look_z=0").camera.eye, {20, 1, 0});
    expect_near(frame_of("orbit=-90&tilt=0&distance=20&look_y=1&look_z=0").camera.eye, {-20, 1, 0});
    expect_near(frame_of("orbit=0&tilt=30&distance=20&look_y=1&look_z=0").camera.eye,
                {0, 11, 20 * std::sqrt(0.75)});
}

TEST(FrameTest, TheCameraFollowsTheTankButDoesNotTurnWithIt)
{
    const CameraView at_rest = frame_of("").camera;
    const CameraView moved = frame_of("x=30&z=-7&heading=90").camera;
    expect_near(moved.eye - at_rest.eye, {30, 0, -7});
    expect_near(moved.centre - at_rest.centre, {30, 0, -7});
}

TEST(FrameTest, TheTankIsDrawnAsTheStateHasIt)
{
    State state;
    open_link(state, "x=3&z=4&turret=30&gun=5&wheels=7&heading=-20&ground=off");
    const Frame frame = make_frame(state, assets::tiny_assets());
    ASSERT_EQ(frame.tanks.size(), 1u);
    EXPECT_EQ(frame.tanks[0].joints, state.joints);
    EXPECT_EQ(frame.tanks[0].position, glm::dvec3(3, 0, 4));
    EXPECT_EQ(frame.tanks[0].level, lod::Level::high);
    EXPECT_FALSE(frame.ground);
    EXPECT_TRUE(frame_of("").ground);
}

TEST(FrameTest, TheEyeIsAlwaysAboveTheGroundAndTheViewIsDefined)
{
    std::mt19937_64 random(31);
    for (int i = 0; i < 20000; ++i) {
        const CameraView camera = make_frame(random_state(random), assets::tiny_assets()).camera;
        ASSERT_GE(camera.eye.y, 0.1);
        const glm::dvec3 sight = glm::normalize(camera.centre - camera.eye);
        ASSERT_GT(glm::length(glm::cross(sight, camera.up)), 0.01); // gluLookAt needs a direction besides up
        ASSERT_GT(camera.near_plane, 0.0);
        ASSERT_LT(camera.near_plane, camera.far_plane);
    }
}

TEST(FrameTest, TheNearPlaneCutsNeitherGroundNorTankOff)
{
    std::mt19937_64 random(37);
    for (int i = 0; i < 5000; ++i) {
        const Frame frame = make_frame(random_state(random), assets::tiny_assets());
        for (const PaneInFrame& pane : frame.panes) {
            const CameraView& camera = pane.camera;
            const double distance = glm::distance(camera.eye, camera.centre);
            const double tilt = std::asin((camera.eye.y - camera.centre.y) / distance);
            // The lower edge of the window meets the ground at this depth along the line of sight; a gunner
            // may look up so far that it does not.
            const double half = camera.field_of_view / 2.0;
            if (tilt + half > 0.0) {
                ASSERT_LE(camera.near_plane, camera.eye.y * std::cos(half) / std::sin(tilt + half));
            }
            ASSERT_LE(camera.near_plane, 0.05 * distance + 1e-12);
            ASSERT_GE(camera.far_plane, distance + 100.0);
        }
    }
}

TEST(FrameTest, DepthTellsThingsApartThatLessThanAPixelSeparates)
{
    for (double distance : {4.0, 12.0, 40.0, 100.0, 400.0}) {
        const CameraView camera = frame_of("distance=" + std::to_string(static_cast<int>(distance))).camera;
        const double n = camera.near_plane;
        const double f = camera.far_plane;
        // One step of a 24-bit depth buffer at the tank; window depth is f / (f - n) * (1 - n / z).
        const double depth_step = distance * distance * (f - n) / (f * n) / 16777216.0;
        const double pixel = 2.0 * distance * std::tan(camera.field_of_view / 2.0) / 2160.0;
        EXPECT_LT(depth_step, 0.2 * pixel) << distance;
    }
}

TEST(FrameTest, TheFirstPictureShowsTheWholeTankWellPlaced)
{
    const Frame frame = frame_of("");
    const tank::PartMatrices matrices =
        tank::part_matrices(tank::default_layout(), {frame.tanks[0].position}, frame.tanks[0].joints);
    // The corners of hull, turret and gun as our meshes have them, in metres.
    struct Box
    {
        tank::Part part;
        glm::dvec3 low, high;
    };
    constexpr Box BOXES[] = {
        {tank::Part::body, {-1.78, 0.0, -3.77}, {1.78, 1.65, 3.75}},
        {tank::Part::turret, {-1.59, 0.0, -2.74}, {1.59, 2.76, 1.74}},
        {tank::Part::main_gun, {-0.2, 0.11, 0.94}, {0.2, 0.73, 6.3}},
    };
    glm::dvec3 low(1e9);
    glm::dvec3 high(-1e9);
    for (const Box& box : BOXES) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 point(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                   corner & 4 ? box.high.z : box.low.z, 1.0);
            const glm::dvec3 world(glm::dmat4(matrices.mesh(box.part)) * point);
            const glm::dvec3 seen = in_window(frame.camera, 1.6, world);
            low = glm::min(low, seen);
            high = glm::max(high, seen);
        }
    }
    EXPECT_GT(low.x, -0.9);
    EXPECT_LT(high.x, 0.9);
    EXPECT_GT(low.y, -0.9);
    EXPECT_LT(high.y, 0.9);
    EXPECT_GT(low.z, -1.0);
    EXPECT_LT(high.z, 1.0);
    EXPECT_GT(high.x - low.x, 1.1); // and it fills more than half of the width
    EXPECT_LT(std::abs(high.x + low.x), 0.35);
    EXPECT_LT(std::abs(high.y + low.y), 0.35);
    // Three quarters from the front: the eye is ahead of the muzzle's side and to one side.
    EXPECT_GT(frame.camera.eye.z, 6.0);
    EXPECT_GT(std::abs(frame.camera.eye.x), 4.0);
}

TEST(FrameTest, ShowsTheAxisOfEitherJointOfTheSecondaryGunWhereItsMetalIs)
{
    const std::string pose = "turret=90&secondary_gun=90&secondary_gun_pitch=30&axis=";
    // The yaw's is upright through the cupola, however high the gun is raised: (-0.55, 2.55, -0.1) about
    // (0, *, 0.25) by a quarter turn to the left.
    const AxisInFrame yaw = frame_of(pose + "secondary_gun").axis;
    ASSERT_TRUE(yaw.is_shown);
    EXPECT_LT(glm::distance(yaw.origin, glm::dvec3(-0.35, 2.55, 0.8)), 1e-6);
    EXPECT_LT(glm::distance(yaw.direction, glm::dvec3(0, 1, 0)), 1e-6);
    // Half round in all, the gun points backwards: its trunnion is behind the cupola, and positive turns
    // raise it.
    const AxisInFrame pitch = frame_of(pose + "secondary_gun_pitch").axis;
    ASSERT_TRUE(pitch.is_shown);
    EXPECT_LT(glm::distance(pitch.origin, glm::dvec3(-0.35, 2.82, 0.49)), 1e-6);
    EXPECT_LT(glm::distance(pitch.direction, glm::dvec3(1, 0, 0)), 1e-6);
}

TEST(FrameTest, MakingAFrameIsPure)
{
    std::mt19937_64 random(41);
    const State state = random_state(random);
    const State copy = state;
    const Frame one = make_frame(state, assets::tiny_assets());
    const Frame other = make_frame(copy, assets::tiny_assets());
    EXPECT_EQ(state, copy);
    EXPECT_EQ(one.camera.eye, other.camera.eye);
    EXPECT_EQ(one.tanks[0].joints, other.tanks[0].joints);
}

} // namespace
} // namespace app
