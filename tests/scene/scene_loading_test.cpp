#include "scene/drawing/read_pixels.h"
#include "scene_renderer_fixture.h"

#include <algorithm>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using recording_gl::ListCall;

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
    assets::Assets assets = scene_test::assets();
    assets.texture = {.width = 1, .height = 1, .channels = 4, .pixels = {1, 2, 3, 4}};
    scene::SceneRenderer renderer;
    ASSERT_EQ(renderer.load(assets), "");
    const std::vector<double>& arguments = first_named(recording_gl::calls(), "glTexImage2D")->arguments;
    EXPECT_EQ(std::vector<double>(arguments.end() - 4, arguments.end()), (std::vector<double>{1, 2, 3, 4}));
}

TEST(SceneRendererLoading, PutsAnotherTankInThePlaceOfTheFirstAndDeletesWhatThatHad)
{
    recording_gl::reset();
    const assets::Assets first = scene_test::assets();
    assets::Assets second = scene_test::assets();
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
        assets::Assets assets = scene_test::assets();
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
    const assets::Assets assets = scene_test::assets();
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
