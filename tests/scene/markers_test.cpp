#include "scene/markers/markers.h"

#include "fixtures.h"
#include "recording_gl.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using recording_gl::ListCall;

class Markers : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        ASSERT_TRUE(shapes.load());
        recording_gl::take_calls();
    }

    recording_gl::Replay draw(const app::Frame& frame)
    {
        glEnable(GL_DEPTH_TEST);
        scene::draw_markers(frame, shapes, 600);
        calls = recording_gl::take_calls();
        return recording_gl::replay(calls);
    }

    /// A frame of the default camera with a probe.
    app::Frame frame_of(app::Probe probe)
    {
        state.projectile.probe = probe;
        return app::make_frame(state, assets);
    }

    assets::Assets assets = scene_test::assets();
    app::State state;
    scene::Shapes shapes;
    std::vector<Call> calls;
};

/// Returns how often each place has a ball or another shape centred on it, in the half of the calls that
/// draws what is not hidden. The modelview is the world's here.
std::map<std::pair<double, double>, int> centres(const recording_gl::Replay& replay)
{
    std::map<std::pair<double, double>, int> counts;
    for (const ListCall& call : replay.list_calls) {
        if (call.depth_writes) {
            ++counts[{call.modelview[3][0], call.modelview[3][1]}];
        }
    }
    return counts;
}

TEST_F(Markers, AreNoneWhereThereIsNothingToMark)
{
    const recording_gl::Replay replay = draw(frame_of(app::Probe::none));
    EXPECT_TRUE(replay.list_calls.empty());
    EXPECT_TRUE(replay.direct_draws.empty());
}

TEST_F(Markers, ShowThePointWhereItIs)
{
    state.projectile.point = {3.0, 2.0, 1.0};
    state.projectile.handle = app::Handle::line_a; // the keys move something else
    const auto counts = centres(draw(frame_of(app::Probe::point)));
    EXPECT_EQ(counts, (std::map<std::pair<double, double>, int>{{{3.0, 2.0}, 1}}));
}

TEST_F(Markers, MarkThePointWhenKeysMoveIt)
{
    state.projectile.point = {3.0, 2.0, 1.0};
    state.projectile.handle = app::Handle::point;
    EXPECT_EQ((centres(draw(frame_of(app::Probe::point)))[{3.0, 2.0}]), 2);
}

TEST_F(Markers, ShowThePointAsLargeAsTheRadiusItIsTestedWith)
{
    state.projectile.radius = 1.25;
    const recording_gl::Replay replay = draw(frame_of(app::Probe::point));
    ASSERT_FALSE(replay.list_calls.empty());
    EXPECT_NEAR(glm::length(replay.list_calls[0].modelview[0]), 1.25, 1e-9);
}

TEST_F(Markers, StayLargeEnoughToBeSeenFromFarAway)
{
    state.camera.distance = 400.0;
    const recording_gl::Replay replay = draw(frame_of(app::Probe::point));
    ASSERT_FALSE(replay.list_calls.empty());
    EXPECT_GT(glm::length(replay.list_calls[0].modelview[0]), 0.005 * 400.0 * 0.8);
}

TEST_F(Markers, ShowTheLinesHandlesAndMarkTheOneThatKeysMove)
{
    state.projectile.a = {1.0, 2.0, 0.0};
    state.projectile.b = {5.0, 3.0, 0.0};
    for (const auto& [handle, at_a, at_b] :
         {std::tuple(app::Handle::line_a, 2, 1), std::tuple(app::Handle::line_b, 1, 2),
          std::tuple(app::Handle::point, 1, 1)}) {
        state.projectile.handle = handle;
        auto counts = centres(draw(frame_of(app::Probe::segment)));
        EXPECT_EQ((counts[{1.0, 2.0}]), at_a);
        EXPECT_EQ((counts[{5.0, 3.0}]), at_b);
        EXPECT_EQ(counts.size(), 2u);
    }
}

TEST_F(Markers, PointBeyondTheHandlesWhereALineGoesOn)
{
    EXPECT_EQ(centres(draw(frame_of(app::Probe::segment))).size(), 2u);
    EXPECT_EQ(centres(draw(frame_of(app::Probe::ray))).size(), 3u);
    EXPECT_EQ(centres(draw(frame_of(app::Probe::line))).size(), 4u);
    state.projectile.b = state.projectile.a; // no direction to point to
    EXPECT_EQ(centres(draw(frame_of(app::Probe::line))).size(), 1u);
}

TEST_F(Markers, JoinClosestPointsToTheirCentres)
{
    app::Frame frame = frame_of(app::Probe::segment);
    frame.closest_points.push_back({{7, 8, 9}, {-1, -2, -3}, true});
    auto counts = centres(draw(frame));
    EXPECT_EQ((counts[{7.0, 8.0}]), 1);
    EXPECT_EQ((counts[{-1.0, -2.0}]), 1);
    const auto vertex = [&](const std::vector<double>& place) {
        return std::any_of(calls.begin(), calls.end(), [&](const Call& call) {
            return call.name == "glVertex3d" && call.arguments == place;
        });
    };
    EXPECT_TRUE(vertex({7, 8, 9}));
    EXPECT_TRUE(vertex({-1, -2, -3}));
}

TEST_F(Markers, TellByColourWhetherThePointIsInsideAMesh)
{
    std::vector<std::vector<double>> colours;
    for (bool is_inside : {false, true}) {
        app::Frame frame = frame_of(app::Probe::none);
        frame.triangles.push_back({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0.1, 0.1, 0}, is_inside});
        colours.push_back(draw(frame).direct_draws.at(0).settings.at("colour"));
    }
    EXPECT_NE(colours[0], colours[1]);
}

TEST_F(Markers, ShowFaintlyWhatIsHidden)
{
    const scene_test::Particles particles(1);
    const app::Frame frame = scene_test::full_frame(assets, particles);
    recording_gl::Replay replay = draw(frame);
    std::vector<ListCall> all = replay.list_calls;
    all.insert(all.end(), replay.direct_draws.begin(), replay.direct_draws.end());
    std::size_t seen = 0;
    std::size_t hidden = 0;
    for (const ListCall& call : all) {
        const bool draws_hidden = call.settings.count("glDepthFunc") != 0 &&
                                  call.settings.at("glDepthFunc") == std::vector<double>{GL_GREATER};
        EXPECT_EQ(call.depth_writes, !draws_hidden);
        EXPECT_TRUE(call.is_enabled(GL_DEPTH_TEST));
        EXPECT_TRUE(call.is_enabled(GL_BLEND));
        if (draws_hidden) {
            EXPECT_LE(call.settings.at("colour")[3], 128.0);
        }
        ++(draws_hidden ? hidden : seen);
    }
    EXPECT_GT(seen, 10u);
    EXPECT_EQ(hidden, seen);
}

} // namespace
