#include "scene_renderer_fixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using recording_gl::ListCall;

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

} // namespace
