#include "scene/scene_renderer.h"

#include "allocation_count.h"
#include "fixtures.h"
#include "recording_gl.h"
#include "scene/read_pixels.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using recording_gl::ListCall;

class SceneRenderer : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        ASSERT_EQ(renderer.load(assets), "");
        loading = recording_gl::take_calls();
    }

    std::vector<Call> draw(int width = 640, int height = 400)
    {
        renderer.draw(app::make_frame(state, assets), width, height);
        return recording_gl::take_calls();
    }

    bool is_of_tank(const ListCall& call) const
    {
        for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
            if (call.list == renderer.tank_lists().list(static_cast<tank::MeshKind>(mesh))) {
                return true;
            }
        }
        return false;
    }

    /// The list calls of the frame, with what loading and the frame itself have enabled.
    recording_gl::Replay replay(const std::vector<Call>& frame) const
    {
        std::vector<Call> all = loading;
        all.insert(all.end(), frame.begin(), frame.end());
        return recording_gl::replay(all);
    }

    app::Assets assets = scene_test::assets();
    app::State state;
    scene::SceneRenderer renderer;
    std::vector<Call> loading;
};

const Call* first_named(const std::vector<Call>& calls, std::string_view name)
{
    const auto found =
        std::find_if(calls.begin(), calls.end(), [&](const Call& call) { return call.name == name; });
    return found == calls.end() ? nullptr : &*found;
}

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

TEST_F(SceneRenderer, FitsTheViewToTheWindow)
{
    const std::vector<Call> frame = draw(300, 200);
    ASSERT_NE(first_named(frame, "glViewport"), nullptr);
    EXPECT_EQ(first_named(frame, "glViewport")->arguments, (std::vector<double>{0, 0, 300, 200}));
    ASSERT_NE(first_named(frame, "gluPerspective"), nullptr);
    EXPECT_NEAR(first_named(frame, "gluPerspective")->arguments[0], 45.0, 1e-12);
    EXPECT_EQ(first_named(frame, "gluPerspective")->arguments[1], 1.5);
}

TEST_F(SceneRenderer, ShowsAsMuchFromSideToSideInANarrowWindowAsInOneOfFiveToFour)
{
    const auto half_width = [&](int width, int height) {
        const std::vector<Call> frame = draw(width, height);
        const Call* perspective = first_named(frame, "gluPerspective");
        return std::tan(perspective->arguments[0] * std::numbers::pi / 360.0) * perspective->arguments[1];
    };
    EXPECT_NEAR(half_width(390, 844), half_width(500, 400), 1e-12);
    EXPECT_NEAR(half_width(400, 400), half_width(500, 400), 1e-12);
    EXPECT_GT(half_width(600, 400), half_width(500, 400));
}

TEST_F(SceneRenderer, DividesTheWindowAmongFourViewsEachWithItsOwnCamera)
{
    state.camera.view = app::View::four;
    const std::vector<Call> frame = draw(640, 400);
    std::vector<std::vector<double>> viewports;
    std::vector<std::vector<double>> scissors;
    std::set<std::vector<double>> eyes;
    std::size_t perspectives = 0;
    for (const Call& call : frame) {
        if (call.name == "glViewport") {
            viewports.push_back(call.arguments);
        } else if (call.name == "glScissor") {
            scissors.push_back(call.arguments);
        } else if (call.name == "gluLookAt") {
            eyes.insert(call.arguments);
        } else if (call.name == "gluPerspective") {
            perspectives += 1u;
            EXPECT_NEAR(call.arguments[1], 1.6, 0.01);
        }
    }
    ASSERT_EQ(viewports.size(), 4u);
    EXPECT_EQ(scissors, viewports);
    EXPECT_EQ(eyes.size(), 4u);
    EXPECT_EQ(perspectives, 4u);
    double covered = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::vector<double>& one = viewports[i];
        covered += one[2] * one[3];
        EXPECT_LE(one[0] + one[2], 640.0);
        EXPECT_LE(one[1] + one[3], 400.0);
        for (std::size_t j = 0; j < i; ++j) {
            const std::vector<double>& other = viewports[j];
            EXPECT_TRUE(one[0] + one[2] < other[0] || other[0] + other[2] < one[0] ||
                        one[1] + one[3] < other[1] || other[1] + other[3] < one[1])
                << i << " and " << j << " meet";
        }
    }
    EXPECT_GT(covered, 0.98 * 640.0 * 400.0);
    const recording_gl::Replay followed = replay(frame);
    EXPECT_EQ(std::count_if(followed.list_calls.begin(), followed.list_calls.end(),
                            [this](const ListCall& call) { return is_of_tank(call); }),
              4 * static_cast<std::ptrdiff_t>(tank::PART_COUNT));
    EXPECT_FALSE(std::binary_search(followed.final_enabled.begin(), followed.final_enabled.end(),
                                    static_cast<unsigned>(GL_SCISSOR_TEST)));
}

TEST_F(SceneRenderer, DividesEvenATinyWindow)
{
    state.camera.view = app::View::four;
    for (const Call& call : draw(1, 1)) {
        if (call.name == "glViewport") {
            EXPECT_EQ(call.arguments[2], 1.0); // a viewport of no width has no aspect
            EXPECT_EQ(call.arguments[3], 1.0);
        }
    }
}

TEST_F(SceneRenderer, DrawsTheSightsCrossOverTheGunnersViewAlone)
{
    const auto crosses = [&](app::View view) {
        state.camera.view = view;
        std::size_t count = 0;
        for (const ListCall& draw : replay(draw()).direct_draws) {
            const bool is_in_the_eyes_frame = draw.modelview[3] == glm::dvec4(0.0, 0.0, 0.0, 1.0);
            count += is_in_the_eyes_frame && !draw.is_enabled(GL_DEPTH_TEST) ? 1u : 0u;
        }
        return count;
    };
    EXPECT_GT(crosses(app::View::gunner), 0u);
    EXPECT_EQ(crosses(app::View::orbit), 0u);
    EXPECT_EQ(crosses(app::View::four), 0u);
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

TEST_F(SceneRenderer, UploadsTheTextureWithFourBytesAPixelAndMipmaps)
{
    const Call* image = first_named(loading, "glTexImage2D");
    ASSERT_NE(image, nullptr);
    std::vector<double> expected = {0, GL_RGBA, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE};
    for (std::size_t pixel = 0; pixel < 6; ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            expected.push_back(static_cast<double>(assets.texture.pixels[pixel * 3 + channel]));
        }
        expected.push_back(255.0);
    }
    EXPECT_EQ(image->arguments, expected);
    bool generates_mipmaps_before = false;
    for (const Call* call = loading.data(); call != image; ++call) {
        generates_mipmaps_before = generates_mipmaps_before || (call->name == "glTexParameteri" &&
                                                                call->arguments[1] == GL_GENERATE_MIPMAP &&
                                                                call->arguments[2] == GL_TRUE);
    }
    EXPECT_TRUE(generates_mipmaps_before);
}

TEST(SceneRendererLoading, KeepsTheAlphaOfATexture)
{
    recording_gl::reset();
    app::Assets assets = scene_test::assets();
    assets.texture = {.width = 1, .height = 1, .channels = 4, .pixels = {1, 2, 3, 4}};
    scene::SceneRenderer renderer;
    ASSERT_EQ(renderer.load(assets), "");
    const std::vector<double>& arguments = first_named(recording_gl::calls(), "glTexImage2D")->arguments;
    EXPECT_EQ(std::vector<double>(arguments.end() - 4, arguments.end()), (std::vector<double>{1, 2, 3, 4}));
}

TEST(SceneRendererLoading, PutsAnotherTankInThePlaceOfTheFirstAndDeletesWhatThatHad)
{
    recording_gl::reset();
    const app::Assets first = scene_test::assets();
    app::Assets second = scene_test::assets();
    second.layout[tank::Part::turret].pivot = {7.0f, 8.0f, 9.0f};
    scene::SceneRenderer renderer;
    ASSERT_EQ(renderer.load(first), "");
    const unsigned old_list = renderer.tank_lists().list(tank::MeshKind::body);
    const unsigned old_low_list = renderer.tank_lists().low_list(tank::MeshKind::body, 0.0);
    const unsigned old_shape_list = renderer.tank_lists().shape_list(tank::MeshKind::body);
    const auto before = static_cast<std::ptrdiff_t>(recording_gl::calls().size());
    ASSERT_EQ(renderer.load_tank(second), "");
    const std::vector<Call> calls(recording_gl::calls().begin() + before, recording_gl::calls().end());
    std::vector<double> deleted;
    for (const Call& call : calls) {
        if (call.name == "glDeleteLists") {
            deleted.push_back(call.arguments[0]);
        }
    }
    EXPECT_EQ(deleted, (std::vector<double>{double(old_list), double(old_low_list), double(old_shape_list)}));
    ASSERT_NE(first_named(calls, "glDeleteTextures"), nullptr);
    EXPECT_EQ(std::count_if(calls.begin(), calls.end(),
                            [](const Call& call) { return call.name == "glTexImage2D"; }),
              1);
    EXPECT_EQ(&renderer.assets(), &second);
}

TEST(SceneRendererLoading, DrawsBothSidesOfFacesThatAreNoClosedSurface)
{
    for (const bool is_one_sided : {true, false}) {
        recording_gl::reset();
        app::Assets assets = scene_test::assets();
        assets.is_one_sided = is_one_sided;
        scene::SceneRenderer renderer;
        ASSERT_EQ(renderer.load(assets), "");
        recording_gl::reset();
        app::State state;
        state.show.ground = false;
        renderer.draw(app::make_frame(state, assets), 320, 200);
        const auto culls = [](const Call& call) {
            return call.name == "glEnable" && call.arguments[0] == GL_CULL_FACE;
        };
        const auto& calls = recording_gl::calls();
        EXPECT_EQ(std::any_of(calls.begin(), calls.end(), culls), is_one_sided);
    }
}

TEST(SceneRendererLoading, SaysWhatOpenGlRefused)
{
    const app::Assets assets = scene_test::assets();
    recording_gl::reset();
    recording_gl::set_error(GL_OUT_OF_MEMORY);
    EXPECT_EQ(scene::SceneRenderer().load(assets),
              "OpenGL could not take the tank's meshes and texture: GL_OUT_OF_MEMORY.");
    recording_gl::reset();
    recording_gl::have_no_list_names();
    EXPECT_NE(scene::SceneRenderer().load(assets), "");
}

TEST(ReadPixels, GivesFourBytesAPixel)
{
    recording_gl::reset();
    const std::vector<std::uint8_t> rgba = scene::read_pixels(3, 2);
    ASSERT_EQ(rgba.size(), 24u);
    EXPECT_EQ(rgba[23], 23);
    EXPECT_EQ(recording_gl::calls().at(0).arguments,
              (std::vector<double>{0, 0, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE}));
}

} // namespace
