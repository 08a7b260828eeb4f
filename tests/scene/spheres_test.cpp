#include "scene/markers/spheres.h"

#include "fixtures.h"
#include "recording_gl.h"
#include "scene/markers/level_colours.h"

#include <cmath>

#include <GL/gl.h>
#include <GL/glu.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using recording_gl::ListCall;

class Spheres : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        ASSERT_TRUE(shapes.load());
        loading = recording_gl::take_calls();
    }

    std::vector<ListCall> draw()
    {
        scene::draw_spheres(frame, shapes);
        replay = recording_gl::replay(recording_gl::take_calls());
        return replay.list_calls;
    }

    /// Returns the calls of the filled sphere's list alone.
    std::vector<ListCall> draw_faces()
    {
        std::vector<ListCall> calls = draw();
        std::erase_if(calls, [this](const ListCall& call) { return call.list != shapes.sphere_list(); });
        return calls;
    }

    void add(double x, double radius, bool is_root, bool is_penetrated)
    {
        frame.spheres.push_back({.centre = {x, 2.0, 3.0},
                                 .radius = radius,
                                 .is_root = is_root,
                                 .part = tank::Part::turret,
                                 .is_penetrated = is_penetrated});
    }

    scene::Shapes shapes;
    std::vector<Call> loading;
    recording_gl::Replay replay;
    app::Frame frame{};
};

double x_of(const ListCall& call)
{
    return call.modelview[3][0];
}

TEST_F(Spheres, AreGluSpheresOfRadiusOneInLists)
{
    std::vector<double> styles;
    std::vector<unsigned> lists;
    double style = 0.0;
    for (const Call& call : loading) {
        if (call.name == "gluQuadricDrawStyle") {
            style = call.arguments[0];
        } else if (call.name == "gluSphere") {
            EXPECT_EQ(call.arguments[0], 1.0);
            styles.push_back(style);
            lists.push_back(call.compiled_into);
        }
    }
    ASSERT_GE(lists.size(), 2u);
    EXPECT_EQ(lists[0], shapes.sphere_list());
    EXPECT_EQ(styles[0], GLU_FILL);
    EXPECT_EQ(lists[1], shapes.wire_sphere_list());
    EXPECT_EQ(styles[1], GLU_LINE);
}

TEST_F(Spheres, StandWhereTheFrameHasThemAndAreAsLarge)
{
    add(5.0, 1.5, false, false);
    const std::vector<ListCall> calls = draw();
    ASSERT_EQ(calls.size(), 1u);
    const glm::dmat4 expected(1.5, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, 1.5, 0, 5.0, 2.0, 3.0, 1.0);
    EXPECT_EQ(calls[0].modelview, expected);
}

TEST_F(Spheres, AreFilledAndTransparentWhenPenetratedAndWireOtherwise)
{
    add(1.0, 1.0, false, false);
    for (const ListCall& call : draw()) {
        EXPECT_EQ(call.list, shapes.wire_sphere_list());
        EXPECT_FALSE(call.is_enabled(GL_LIGHTING)); // wires have no normals
    }
    frame.spheres[0].is_penetrated = true;
    const std::vector<ListCall> faces = draw_faces();
    EXPECT_EQ(faces.size(), 2u);
    for (const ListCall& call : faces) {
        EXPECT_GT(call.settings.at("colour")[3], 0.0);
        EXPECT_LT(call.settings.at("colour")[3], 128.0);
    }
}

TEST_F(Spheres, AreBlendedTestedByDepthAndWriteNone)
{
    glEnable(GL_DEPTH_TEST);
    add(1.0, 4.0, true, true);
    add(1.0, 1.0, false, true);
    add(1.0, 1.0, false, false);
    scene::draw_spheres(frame, shapes);
    const recording_gl::Replay followed = recording_gl::replay(recording_gl::take_calls());
    for (const ListCall& call : followed.list_calls) {
        EXPECT_TRUE(call.is_enabled(GL_BLEND));
        EXPECT_TRUE(call.is_enabled(GL_DEPTH_TEST));
        EXPECT_FALSE(call.depth_writes);
        EXPECT_EQ(call.settings.at("glBlendFunc"),
                  (std::vector<double>{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
    }
    EXPECT_TRUE(followed.final_depth_writes);
}

TEST_F(Spheres, ShowTheirFarHalvesBeforeTheirNearOnes)
{
    add(1.0, 1.0, false, true);
    const std::vector<ListCall> faces = draw_faces();
    ASSERT_EQ(faces.size(), 2u);
    for (const ListCall& call : faces) {
        EXPECT_TRUE(call.is_enabled(GL_CULL_FACE));
    }
    EXPECT_EQ(faces[0].settings.at("glCullFace"), std::vector<double>{GL_FRONT});
    EXPECT_EQ(faces[1].settings.at("glCullFace"), std::vector<double>{GL_BACK});
}

TEST_F(Spheres, GoFromFarToNearAndTheRootIsAroundAllOthers)
{
    // The frame has the furthest centre first; the root's is somewhere between.
    add(1.0, 1.0, false, true);
    add(2.0, 9.0, true, true);
    add(3.0, 1.0, false, true);
    add(4.0, 1.0, false, true);
    std::vector<double> order;
    for (const ListCall& call : draw_faces()) {
        order.push_back(x_of(call));
    }
    EXPECT_EQ(order, (std::vector<double>{2, 1, 1, 3, 3, 4, 4, 2}));
}

TEST_F(Spheres, HaveAColourForEachLevel)
{
    add(1.0, 1.0, false, true);
    add(2.0, 9.0, true, true);
    for (const ListCall& call : draw()) {
        const scene::Rgb expected = scene::level_colour(x_of(call) == 2.0);
        const std::vector<double>& colour = call.settings.at("colour");
        EXPECT_EQ((std::vector<double>{colour[0], colour[1], colour[2]}),
                  (std::vector<double>{double(expected.red), double(expected.green), double(expected.blue)}));
    }
    const scene::Rgb root = scene::level_colour(true);
    const scene::Rgb part = scene::level_colour(false);
    EXPECT_GT(std::abs(root.red - part.red) + std::abs(root.blue - part.blue), 200);
}

} // namespace
