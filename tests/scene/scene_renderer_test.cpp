#include "allocation_count/allocation_count.h"
#include "scene_renderer_fixture.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <string>
#include <tuple>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using recording_gl::ListCall;

TEST_F(SceneRenderer, DrawsEveryPartUnderViewTimesItsWorldMatrix)
{
    state.joints.radians = {0.3, -0.8, 0.2, 1.1, 2.0, -2.0};
    state.x = 4.0;
    state.z = -7.0;
    const recording_gl::Replay followed = replay(draw());
    const app::Frame frame = app::make_frame(state, assets);
    const glm::dmat4 view = glm::lookAt(frame.camera.eye, frame.camera.centre, frame.camera.up);
    const tank::PartMatrices matrices =
        tank::part_matrices(assets.layout, {frame.tanks[0].position}, state.joints);
    std::size_t found = 0;
    for (const ListCall& call : followed.list_calls) {
        for (tank::Part part : tank::ALL_PARTS) {
            const glm::dmat4 expected = view * glm::dmat4(matrices.mesh(part));
            double difference = 0.0;
            for (int column = 0; column < 4; ++column) {
                for (int row = 0; row < 4; ++row) {
                    difference =
                        std::max(difference, std::abs(call.modelview[column][row] - expected[column][row]));
                }
            }
            const bool is_mesh = call.list == renderer.tank_lists().list(assets.layout[part].mesh);
            found += is_mesh && difference < 2e-5 ? 1u : 0u;
        }
    }
    EXPECT_EQ(found, tank::PART_COUNT);
    EXPECT_EQ(followed.final_stack_depth, 0u);
    EXPECT_FALSE(followed.popped_too_often);
}

TEST_F(SceneRenderer, LightsTexturesAndCullsTheTankOnly)
{
    for (const ListCall& call : replay(draw()).list_calls) {
        EXPECT_EQ(call.is_enabled(GL_TEXTURE_2D), is_of_tank(call));
        EXPECT_EQ(call.is_enabled(GL_CULL_FACE), is_of_tank(call));
        EXPECT_EQ(call.depth_writes, is_of_tank(call) || !call.is_enabled(GL_DEPTH_TEST));
        EXPECT_TRUE(call.is_enabled(GL_NORMALIZE));
        if (is_of_tank(call)) {
            EXPECT_TRUE(call.is_enabled(GL_LIGHTING));
            EXPECT_TRUE(call.is_enabled(GL_LIGHT0));
            EXPECT_TRUE(call.is_enabled(GL_LIGHT1));
            EXPECT_TRUE(call.is_enabled(GL_DEPTH_TEST));
            EXPECT_FALSE(call.is_enabled(GL_BLEND));
            EXPECT_FALSE(call.is_enabled(GL_COLOR_MATERIAL));
        }
    }
}

TEST_F(SceneRenderer, ClearsWithDepthWritesOn)
{
    EXPECT_TRUE(replay(draw()).final_depth_writes); // glClear of the next frame would be masked
}

TEST_F(SceneRenderer, FixesTheLightsToTheWorld)
{
    const recording_gl::Replay followed = replay(draw());
    const app::Frame frame = app::make_frame(state, assets);
    const glm::dmat4 view = glm::lookAt(frame.camera.eye, frame.camera.centre, frame.camera.up);
    ASSERT_EQ(followed.light_positions_set_under.size(), 2u);
    for (const glm::dmat4& modelview : followed.light_positions_set_under) {
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                EXPECT_NEAR(modelview[column][row], view[column][row], 1e-12);
            }
        }
    }
}

TEST_F(SceneRenderer, DarkensTheGroundUnderAHullOnlyWhereASolidOneIsDrawn)
{
    recording_gl::have_no_stencil(); // no shadow of the sun's then
    const auto of_surroundings = [&] {
        const std::vector<ListCall> calls = replay(draw()).list_calls;
        return std::count_if(calls.begin(), calls.end(),
                             [this](const ListCall& call) { return !is_of_tank(call); });
    };
    const auto with_hull = of_surroundings();
    state.show.parts = app::PartsShown::turret;
    EXPECT_EQ(of_surroundings(), with_hull - 1);
    state.show.parts = app::PartsShown::all;
    state.show.wireframe = true;
    EXPECT_EQ(of_surroundings(), with_hull - 1);
}

TEST_F(SceneRenderer, LeavesTheGroundOutWhenItIsHidden)
{
    const std::size_t with_ground = replay(draw()).list_calls.size();
    state.show.ground = false;
    const recording_gl::Replay without = replay(draw());
    EXPECT_LT(without.list_calls.size(), with_ground);
    EXPECT_EQ(without.list_calls.size(), 1 + tank::PART_COUNT); // the sky, the tank
}

TEST_F(SceneRenderer, CompilesAndUploadsNothingInAFrame)
{
    for (const Call& call : draw()) {
        for (const char* name : {"glGenLists", "glNewList", "glVertex3f", "glGenTextures", "glTexImage2D"}) {
            EXPECT_NE(call.name, name);
        }
    }
}

TEST_F(SceneRenderer, MakesTheSameCallsForTheSameState)
{
    const std::vector<Call> first = draw();
    const std::vector<Call> second = draw();
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].name, second[i].name);
        EXPECT_EQ(first[i].arguments, second[i].arguments);
    }
}

TEST_F(SceneRenderer, AllocatesNothingInAFrame)
{
    const app::Frame frame = app::make_frame(state, assets);
    recording_gl::record(false);
    const std::size_t before = allocation_count();
    renderer.draw(frame, 640, 400);
    EXPECT_EQ(allocation_count(), before);
}

TEST_F(SceneRenderer, AllocatesAndCompilesNothingForAFrameWithEverythingInIt)
{
    const scene_test::Particles particles(5000);
    const app::Frame frame = scene_test::full_frame(assets, particles);
    recording_gl::record(false);
    const std::size_t before = allocation_count();
    renderer.draw(frame, 640, 400);
    EXPECT_EQ(allocation_count(), before);
    recording_gl::record(true);
    renderer.draw(frame, 640, 400);
    for (const Call& call : recording_gl::take_calls()) {
        for (const char* name : {"glGenLists", "glNewList", "gluSphere", "glGenTextures", "glTexImage2D"}) {
            EXPECT_NE(call.name, name);
        }
    }
}

TEST_F(SceneRenderer, LeavesOpenGlAtRestWhateverItDraws)
{
    const scene_test::Particles particles(3);
    const recording_gl::Replay before = replay(draw());
    renderer.draw(scene_test::full_frame(assets, particles), 640, 400);
    const recording_gl::Replay after = replay(recording_gl::take_calls());
    EXPECT_EQ(after.final_enabled, before.final_enabled);
    EXPECT_EQ(after.final_enabled,
              (std::vector<unsigned>{GL_DEPTH_TEST, GL_NORMALIZE, GL_LIGHT0, GL_LIGHT1}));
    EXPECT_TRUE(after.final_depth_writes);
    EXPECT_EQ(after.final_stack_depth, 0u);
    EXPECT_FALSE(after.popped_too_often);
    for (const auto& [name, expected] : recording_gl::Settings{
             {"glBlendFunc", {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}},
             {"glDepthFunc", {GL_LEQUAL}},
             {"glDepthMask", {GL_TRUE}},
             {"glCullFace", {GL_BACK}},
             {"glLineWidth", {1.0}},
             {"glPolygonMode", {GL_FRONT_AND_BACK, GL_FILL}},
             {"glMatrixMode", {GL_MODELVIEW}},
             {"glStencilFunc", {GL_ALWAYS, 0.0, double(~0u)}},
             {"glStencilOp", {GL_KEEP, GL_KEEP, GL_KEEP}},
         }) {
        EXPECT_EQ(after.final_settings.at(name), expected) << name;
    }
    for (unsigned array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY}) {
        EXPECT_EQ(after.final_settings.count("array " + std::to_string(array)), 0u);
    }
}

TEST_F(SceneRenderer, DrawsTheTankTheSameWhateverElseIsDrawn)
{
    const auto tank_calls = [&](const app::Frame& frame) {
        renderer.draw(frame, 640, 400);
        std::vector<ListCall> calls = replay(recording_gl::take_calls()).list_calls;
        std::erase_if(calls, [&](const ListCall& call) { return !is_of_tank(call); });
        return calls;
    };
    const scene_test::Particles particles(3);
    app::Frame full = scene_test::full_frame(assets, particles);
    full.wireframe = false;
    const std::vector<ListCall> alone = tank_calls(app::make_frame(state, assets));
    tank_calls(full); // what it leaves behind, the next frame finds
    const std::vector<ListCall> among = tank_calls(full);
    ASSERT_EQ(among.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(among[i].modelview, alone[i].modelview);
        EXPECT_EQ(among[i].enabled, alone[i].enabled);
        EXPECT_EQ(among[i].settings.at("glBlendFunc"), alone[i].settings.at("glBlendFunc"));
        EXPECT_TRUE(among[i].depth_writes);
    }
}

TEST_F(SceneRenderer, DrawsTheLevelThatTheFrameSays)
{
    const auto count = [&](const std::vector<ListCall>& calls, bool low) {
        return std::count_if(calls.begin(), calls.end(), [&](const ListCall& call) {
            const auto body = tank::MeshKind::body;
            const scene::TankLists& lists = renderer.tank_lists();
            return low ? lists.low_mesh_of(call.list) == body : call.list == lists.list(body);
        });
    };
    for (const auto& [detail, high, low] :
         {std::tuple(app::Detail::high, 1, 0), std::tuple(app::Detail::low, 0, 1),
          std::tuple(app::Detail::both, 1, 1)}) {
        state.show.detail = detail;
        const std::vector<ListCall> calls = replay(draw()).list_calls;
        EXPECT_EQ(count(calls, false), high);
        EXPECT_EQ(count(calls, true), low);
    }
}

TEST_F(SceneRenderer, DrawsTheEdgesOfTheTanksAlone)
{
    state.show.wireframe = true;
    state.show.detail = app::Detail::both;
    std::size_t of_tanks = 0;
    for (const ListCall& call : replay(draw()).list_calls) {
        const auto mode = call.settings.find("glPolygonMode");
        const bool edges =
            mode != call.settings.end() && mode->second == std::vector<double>{GL_FRONT_AND_BACK, GL_LINE};
        of_tanks += edges ? 1u : 0u;
        EXPECT_TRUE(edges || !is_of_tank(call));
    }
    EXPECT_EQ(of_tanks, 2 * tank::PART_COUNT);
}

} // namespace
