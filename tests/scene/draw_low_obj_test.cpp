#include "scene/tank/draw_low_obj.h"

#include "recording_gl.h"
#include "scene/drawing/lights.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace {

using recording_gl::Call;
using std::numbers::pi;

/// Returns a mesh of two faces, one that looks along `first` and one that looks along `second`.
mesh::ObjMesh two_faces(const glm::vec3& first, const glm::vec3& second)
{
    mesh::ObjMesh obj;
    obj.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    obj.normals = {first, second};
    for (int normal : {0, 1}) {
        mesh::Face face{};
        for (int corner : {0, 1, 2}) {
            face.vertices[static_cast<std::size_t>(corner)] = {.position = corner, .normal = normal};
        }
        obj.faces.push_back(face);
    }
    return obj;
}

assets::FacePaint of_one_colour(const glm::vec3& colour)
{
    return {colour, colour, colour};
}

/// Returns the colour of each vertex, of 255.
std::vector<glm::vec3> colours(const mesh::ObjMesh& obj, const std::vector<assets::FacePaint>& paint,
                               const scene::LowPose& pose)
{
    recording_gl::reset();
    scene::draw_low_obj(obj, paint, pose);
    std::vector<glm::vec3> found;
    glm::vec3 current(-1.0f);
    for (const Call& call : recording_gl::calls()) {
        if (call.name == "glColor3ub") {
            current = {call.arguments[0], call.arguments[1], call.arguments[2]};
        } else if (call.name == "glVertex3f") {
            found.push_back(current);
        }
    }
    return found;
}

void expect_near(const glm::vec3& colour, const glm::vec3& expected)
{
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(colour[channel], 255.0f * expected[channel], 0.6f);
    }
}

TEST(DrawLowObj, ColoursEachCornerByPaintTimesLight)
{
    const glm::vec3 up(0, 3, 0);
    const glm::vec3 down(0, -0.5f, 0);
    const std::vector<assets::FacePaint> paint = {
        {{{0.5f, 0.4f, 0.3f}, {0.1f, 0.2f, 0.3f}, {0.6f, 0.5f, 0.4f}}}, of_one_colour({0.9f, 0.8f, 0.7f})};
    const std::vector<glm::vec3> found =
        colours(two_faces(up, down), paint, {.yaw = 1.0, .turns_about_x = false});
    ASSERT_EQ(found.size(), 6u);
    expect_near(found[0], paint[0][0] * scene::light_on({0, 1, 0}));
    expect_near(found[2], paint[0][2] * scene::light_on({0, 1, 0}));
    expect_near(found[5], paint[1][0] * scene::light_on({0, -1, 0}));
    EXPECT_GT(scene::light_on({0, 1, 0}).r, 1.5f * scene::light_on({0, -1, 0}).r);
}

TEST(DrawLowObj, IsLitAsItsYawTurnsItToTheSun)
{
    const std::vector<assets::FacePaint> paint(2, of_one_colour(glm::vec3(1.0f)));
    const double to_sun = std::atan2(double(scene::TO_SUN.x), double(scene::TO_SUN.z));
    const mesh::ObjMesh ahead_and_back = two_faces({0, 0, 1}, {0, 0, -1});
    const std::vector<glm::vec3> towards =
        colours(ahead_and_back, paint, {.yaw = to_sun, .turns_about_x = false});
    const std::vector<glm::vec3> away =
        colours(ahead_and_back, paint, {.yaw = to_sun + pi, .turns_about_x = false});
    EXPECT_GT(towards[0].r, towards[3].r + 60.0f);
    EXPECT_LT(glm::distance(towards[0], away[3]), 1.0f);
    EXPECT_LT(glm::distance(towards[3], away[0]), 1.0f);
}

TEST(DrawLowObj, LightsAWheelTheSameAllRound)
{
    const std::vector<assets::FacePaint> paint(2, of_one_colour(glm::vec3(1.0f)));
    const mesh::ObjMesh rim = two_faces({0, 1, 0}, {0, -1, 0});
    const std::vector<glm::vec3> wheel = colours(rim, paint, {.yaw = 0.3, .turns_about_x = true});
    EXPECT_LT(glm::distance(wheel[0], wheel[3]), 2.0f);
    const mesh::ObjMesh sides = two_faces({1, 0, 0}, {-1, 0, 0});
    const std::vector<glm::vec3> side = colours(sides, paint, {.yaw = 0.3, .turns_about_x = true});
    expect_near(side[0], scene::light_on({std::cos(0.3), 0, -std::sin(0.3)}));
}

TEST(DrawLowObj, IsWhiteWhereThereIsNoPaint)
{
    const std::vector<glm::vec3> found =
        colours(two_faces({0, 1, 0}, {0, 1, 0}), {of_one_colour(glm::vec3(0.0f))},
                {.yaw = 0.0, .turns_about_x = false});
    expect_near(found[0], glm::vec3(0.0f));
    expect_near(found[3], scene::light_on({0, 1, 0}));
}

} // namespace
