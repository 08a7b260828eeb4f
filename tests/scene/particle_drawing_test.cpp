#include "scene/particles/particle_drawing.h"

#include "fixtures.h"
#include "recording_gl.h"
#include "scene/particles/particle_textures.h"

#include <cstring>
#include <glm/geometric.hpp>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;

/// A vertex as GL_T2F_C4UB_V3F has it.
struct Vertex
{
    float s, t;
    std::uint8_t colour[4];
    float x, y, z;

    glm::vec3 place() const { return {x, y, z}; }
};
static_assert(sizeof(Vertex) == 24);

class ParticleDrawing : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        drawing.load();
        recording_gl::take_calls();
        frame = app::make_frame(app::State{}, assets);
    }

    recording_gl::Replay draw(const particles::ParticleView& view)
    {
        frame.particles = {view};
        glEnable(GL_DEPTH_TEST);
        drawing.draw(frame, 600);
        calls = recording_gl::take_calls();
        return recording_gl::replay(calls);
    }

    /// Returns the vertices of all arrays drawn, in their order.
    std::vector<Vertex> vertices() const
    {
        std::vector<Vertex> all;
        for (const Call& call : calls) {
            std::vector<Vertex> some(call.arrays.size() / sizeof(Vertex));
            if (!some.empty()) {
                std::memcpy(some.data(), call.arrays.data(), some.size() * sizeof(Vertex));
            }
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }

    const assets::Assets assets = scene_test::assets();
    app::Frame frame{};
    scene::ParticleDrawing drawing;
    std::vector<Call> calls;
};

TEST_F(ParticleDrawing, DoesNothingWithoutParticles)
{
    frame.particles.clear();
    drawing.draw(frame, 600);
    EXPECT_TRUE(recording_gl::calls().empty());
}

TEST_F(ParticleDrawing, TestsDepthAndWritesNoneWithoutLight)
{
    const scene_test::Particles particles(3);
    const recording_gl::Replay replay = draw(particles.view());
    ASSERT_FALSE(replay.direct_draws.empty());
    for (const recording_gl::ListCall& call : replay.direct_draws) {
        EXPECT_TRUE(call.is_enabled(GL_DEPTH_TEST));
        EXPECT_FALSE(call.depth_writes);
        EXPECT_TRUE(call.is_enabled(GL_BLEND));
        EXPECT_TRUE(call.is_enabled(GL_TEXTURE_2D));
        EXPECT_FALSE(call.is_enabled(GL_LIGHTING));
        EXPECT_FALSE(call.is_enabled(GL_CULL_FACE));
    }
}

TEST_F(ParticleDrawing, BlendsAsTheViewSays)
{
    const scene_test::Particles particles(1);
    particles::ParticleView view = particles.view();
    view.blending = particles::Blending::additive;
    EXPECT_EQ(draw(view).direct_draws.at(0).settings.at("glBlendFunc"),
              (std::vector<double>{GL_SRC_ALPHA, GL_ONE}));
    view.blending = particles::Blending::over;
    EXPECT_EQ(draw(view).direct_draws.at(0).settings.at("glBlendFunc"),
              (std::vector<double>{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
}

TEST_F(ParticleDrawing, GivesEveryParticleFourCornersAroundIt)
{
    const scene_test::Particles particles(5000); // more than are given to OpenGL at once
    const particles::ParticleView view = particles.view();
    draw(view);
    const std::vector<Vertex> all = vertices();
    ASSERT_EQ(all.size(), 4 * 5000u);
    for (std::size_t i = 0; i < 5000; ++i) {
        glm::vec3 sum(0.0f);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            sum += all[4 * i + corner].place();
            EXPECT_EQ(std::memcmp(all[4 * i + corner].colour, &particles.ramp[64], 3), 0);
        }
        ASSERT_LT(glm::distance(0.25f * sum, view.position(i)), 1e-3f) << i;
    }
}

TEST_F(ParticleDrawing, DrawsADotAsASquareOfItsSizeThatFacesTheEye)
{
    const scene_test::Particles particles(1);
    const particles::ParticleView view = particles.view();
    draw(view);
    const std::vector<Vertex> all = vertices();
    ASSERT_EQ(all.size(), 4u);
    const glm::vec3 right = all[1].place() - all[0].place();
    const glm::vec3 up = all[3].place() - all[0].place();
    EXPECT_NEAR(glm::length(right), 0.15f, 1e-5f); // a quarter of the way from 0.1 to 0.3
    EXPECT_NEAR(glm::length(up), 0.15f, 1e-5f);
    EXPECT_NEAR(glm::dot(right, up), 0.0f, 1e-6f);
    const glm::dvec3 forward = app::view_axes(frame.camera).forward;
    EXPECT_NEAR(glm::dot(glm::vec3(forward), glm::normalize(glm::cross(right, up))), -1.0f, 1e-5f);
    EXPECT_EQ(all[2].place(), all[1].place() + up); // all four in a plane
}

TEST_F(ParticleDrawing, DrawsAStreakFromWhereItsParticleWasToWhereItIs)
{
    const scene_test::Particles particles(1);
    particles::ParticleView view = particles.view();
    view.texture = particles::TextureKind::streak;
    draw(view);
    const std::vector<Vertex> all = vertices();
    ASSERT_EQ(all.size(), 4u);
    const glm::vec3 way = view.position(0) - view.streak_end(0);
    const glm::vec3 along = all[3].place() - all[0].place();
    EXPECT_NEAR(glm::dot(glm::normalize(along), glm::normalize(way)), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::length(along), glm::length(way) + 0.15f, 1e-5f); // and half its width beyond both ends
    EXPECT_NEAR(glm::distance(all[1].place(), all[0].place()), 0.15f, 1e-5f);
    EXPECT_GT(all[3].t, all[0].t); // the head of the texture is at the head
}

TEST_F(ParticleDrawing, DrawsAStreakWithoutLengthAsADot)
{
    scene_test::Particles particles(1);
    particles.age[0] = 0.0f; // just released
    particles::ParticleView view = particles.view();
    view.texture = particles::TextureKind::streak;
    draw(view);
    const std::vector<Vertex> all = vertices();
    ASSERT_EQ(all.size(), 4u);
    EXPECT_NEAR(glm::distance(all[3].place(), all[0].place()), 0.1f, 1e-5f);
    EXPECT_NEAR(glm::distance(all[1].place(), all[0].place()), 0.1f, 1e-5f);
}

TEST_F(ParticleDrawing, MakesWhatIsNarrowerThanPixelsFainterInsteadOfNarrower)
{
    const scene_test::Particles particles(1);
    const particles::ParticleView view = particles.view();
    frame.camera.eye = {0.0, 1.0, 2001.0}; // 2 km away; the window shows 1.66 km from there
    frame.camera.centre = {0.0, 1.0, 1.0};
    draw(view);
    const std::vector<Vertex> all = vertices();
    ASSERT_EQ(all.size(), 4u);
    const float width = glm::distance(all[1].place(), all[0].place());
    EXPECT_NEAR(width, 1.5 * 2000.0 * 0.828427 / 600.0, 0.01);
    EXPECT_NEAR(all[0].colour[3], 200.0f * 0.15f / width, 0.51f);
}

TEST(ParticleTextures, FadeTowardsTheirRims)
{
    for (const image::Image& image : {scene::soft_dot_image(), scene::streak_image()}) {
        ASSERT_EQ(image.channels, 4);
        const auto alpha = [&](int x, int y) {
            return int(image.pixels[4 * (static_cast<std::size_t>(y * image.width + x)) + 3]);
        };
        const int last = image.width - 1;
        int greatest = 0;
        for (int i = 0; i <= last; ++i) {
            EXPECT_LE(alpha(0, i), 2);
            EXPECT_LE(alpha(last, i), 2);
            EXPECT_LE(alpha(i, 0), 2);
            EXPECT_LE(alpha(i, last), 3);
            for (int j = 0; j <= last; ++j) {
                greatest = std::max(greatest, alpha(i, j));
                EXPECT_EQ(alpha(i, j), alpha(last - i, j)); // the same to both sides
            }
        }
        EXPECT_GT(greatest, 245);
    }
}

} // namespace
