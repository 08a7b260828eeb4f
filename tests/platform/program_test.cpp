#include "platform/program/program.h"

#include "app/links/links.h"
#include "assets/users_tank.h"
#include "original_set.h"
#include "platform/files/asset_files.h"
#include "platform/offscreen/offscreen_target.h"
#include "scene/drawing/read_pixels.h"

#include <memory>

#include <gtest/gtest.h>
#include <legacygl/legacygl.h>

namespace {

constexpr int WIDTH = 96;
constexpr int HEIGHT = 64;

class Program : public ::testing::Test
{
protected:
    void SetUp() override
    {
        std::string error;
        target = platform::open_offscreen_target(WIDTH, HEIGHT, error);
        ASSERT_EQ(error, "");
        assets::Assets assets;
        ASSERT_EQ(platform::read_asset_folder(ASSETS, assets), "");
        ASSERT_EQ(program.start(std::move(assets)), "");
    }

    std::unique_ptr<platform::OffscreenTarget> target;
    platform::Program program;
};

TEST_F(Program, DrawsOnlyWhenSomethingChanged)
{
    EXPECT_TRUE(program.draw_if_changed(WIDTH, HEIGHT));
    EXPECT_FALSE(program.draw_if_changed(WIDTH, HEIGHT));
    program.advance(1.0);
    EXPECT_FALSE(program.draw_if_changed(WIDTH, HEIGHT)); // time alone changes nothing
    EXPECT_EQ(program.command("turret", 10.0), "");
    EXPECT_TRUE(program.draw_if_changed(WIDTH, HEIGHT));
    EXPECT_TRUE(program.draw_if_changed(WIDTH / 2, HEIGHT));
    EXPECT_FALSE(program.draw_if_changed(WIDTH / 2, HEIGHT));
    program.redraw();
    EXPECT_TRUE(program.draw_if_changed(WIDTH / 2, HEIGHT));
}

TEST_F(Program, ShowsWhatACommandChanged)
{
    program.draw_if_changed(WIDTH, HEIGHT);
    const auto before = scene::read_pixels(WIDTH, HEIGHT);
    program.command("turret", 60.0);
    program.draw_if_changed(WIDTH, HEIGHT);
    EXPECT_NE(before, scene::read_pixels(WIDTH, HEIGHT));
    program.command("turret", 0.0);
    program.draw_if_changed(WIDTH, HEIGHT);
    EXPECT_EQ(before, scene::read_pixels(WIDTH, HEIGHT));
}

TEST_F(Program, ShowsATankThatIsBroughtAndOursAgain)
{
    program.command("turret", 20.0);
    program.draw_if_changed(WIDTH, HEIGHT);
    const auto ours = scene::read_pixels(WIDTH, HEIGHT);
    const assets::Files files = assets::original_set();
    for (int time = 0; time < 2; ++time) { // the second one takes the place of the first
        ASSERT_EQ(
            program.set_user_tank(assets::read_users_tank(files.views(), assets::PAINT_VIEW).value().assets),
            "");
        EXPECT_EQ(app::link(program.state()), "turret=20&tank=own");
        EXPECT_TRUE(program.draw_if_changed(WIDTH, HEIGHT));
        EXPECT_NE(ours, scene::read_pixels(WIDTH, HEIGHT));
    }
    program.command("tank", 0.0);
    EXPECT_TRUE(program.draw_if_changed(WIDTH, HEIGHT));
    EXPECT_EQ(ours, scene::read_pixels(WIDTH, HEIGHT));
    program.open_link("turret=20&tank=own");
    EXPECT_TRUE(program.draw_if_changed(WIDTH, HEIGHT));
    EXPECT_NE(ours, scene::read_pixels(WIDTH, HEIGHT));
}

TEST_F(Program, KeepsTheTankWhenOpenGlRefusesAnother)
{
    program.draw_if_changed(WIDTH, HEIGHT);
    const auto ours = scene::read_pixels(WIDTH, HEIGHT);
    const assets::Files files = assets::original_set();
    assets::Assets assets = assets::read_users_tank(files.views(), assets::PAINT_VIEW).value().assets;
    assets.texture = {
        .width = 1 << 17, .height = 1, .channels = 3, .pixels = std::vector<std::uint8_t>(3u << 17)};
    EXPECT_NE(program.set_user_tank(std::move(assets)).find("OpenGL could not take"), std::string::npos);
    EXPECT_EQ(app::link(program.state()), "");
    EXPECT_FALSE(program.simulation().has_own_tank());
    program.draw_if_changed(WIDTH, HEIGHT);
    EXPECT_EQ(ours, scene::read_pixels(WIDTH, HEIGHT));
}

TEST_F(Program, MovesWhatIsHeldByTheTimeThatPasses)
{
    program.command("turret_left", 1.0);
    for (int i = 0; i < 100; ++i) {
        program.advance(0.01);
    }
    program.command("turret_left", 0.0);
    EXPECT_NEAR(program.state().joints[tank::Joint::turret], 40.0 * 3.14159265358979 / 180.0, 0.02);
}

TEST_F(Program, SaysWhatIsWrongWithCommandsAndLinks)
{
    EXPECT_NE(program.command("fly", 1.0), "");
    EXPECT_EQ(program.open_link("turret=5&wings=2").size(), 1u);
    EXPECT_EQ(program.open_link("turret=5").size(), 0u);
}

/// Draws the same twice, then with the turret turned to an angle that it did not have, and returns what the
/// last frame took.
LegacyGLCounters counters_of_steady_frame(platform::Program& program, double turret_degrees)
{
    program.draw_if_changed(WIDTH, HEIGHT);
    program.redraw();
    program.draw_if_changed(WIDTH, HEIGHT);
    legacygl_reset_counters(legacygl_current());
    program.command("turret", turret_degrees);
    program.draw_if_changed(WIDTH, HEIGHT);
    return legacygl_counters(legacygl_current());
}

TEST_F(Program, CompilesNoShaderAndUploadsNoGeometryInASteadyFrame)
{
    program.command("ground", 0.0);
    const LegacyGLCounters counters = counters_of_steady_frame(program, 20.0);
    EXPECT_GT(counters.draw_calls, 4u);
    EXPECT_EQ(counters.programs, 0u);
    EXPECT_EQ(counters.uploads, 0u);
}

TEST_F(Program, StreamsOfTheShadowTheRowOfWheelsAloneOnceALayer)
{
    // legacygl draws a row of one small list, the wheel's shape, as one stream: vertices and slots of
    // transforms. Without the wheels there is what the ground's grid streams where ES does not cut lines.
    program.open_link("parts=body");
    const LegacyGLCounters ground = counters_of_steady_frame(program, 20.0);
    program.open_link("");
    const LegacyGLCounters counters = counters_of_steady_frame(program, 20.0);
    constexpr std::uint64_t LAYERS = 8;
    EXPECT_GT(counters.draw_calls, 18u);
    EXPECT_EQ(counters.programs, 0u);
    EXPECT_LE(counters.uploads - ground.uploads, 2 * LAYERS);
    EXPECT_LT(counters.upload_bytes - ground.upload_bytes, 400'000u);
}

} // namespace
