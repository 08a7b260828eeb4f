#include "scene/tank/draw_tank.h"

#include "fixtures.h"
#include "recording_gl.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using tank::Joint;
using tank::Part;

/// The parts in the order in which walking the tree meets them: a part, then each child with its own.
void append_with_children(const tank::Layout& layout, Part part, std::vector<Part>& order)
{
    order.push_back(part);
    for (Part child : tank::ALL_PARTS) {
        if (child != part && layout[child].parent == part) {
            append_with_children(layout, child, order);
        }
    }
}

std::vector<Part> order_of(const tank::Layout& layout)
{
    std::vector<Part> order;
    append_with_children(layout, Part::body, order);
    return order;
}

collision::PartSet all_parts()
{
    return collision::PartSet((std::uint64_t{1} << tank::PART_COUNT) - 1);
}

class DrawTank : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
        ASSERT_TRUE(lists.load_low_detail_tank_objs(scene_test::assets().low));
        recording_gl::take_calls();
    }

    std::vector<Call> draw(float x, float y, float z)
    {
        scene::TankDrawing(lists, layout, joints, parts).draw_tank(x, y, z);
        return recording_gl::take_calls();
    }

    std::vector<Call> draw_low(float x, float y, float z)
    {
        scene::TankDrawing(lists, layout, joints, parts).draw_tank_low(x, y, z);
        return recording_gl::take_calls();
    }

    void expect_part_matrices(const std::vector<Call>& calls, const glm::dvec3& position)
    {
        const recording_gl::Replay replay = recording_gl::replay(calls);
        const tank::PartMatrices matrices = tank::part_matrices(layout, {position}, joints);
        const std::vector<Part> order = order_of(layout);
        ASSERT_EQ(replay.list_calls.size(), order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            SCOPED_TRACE(tank::part_name(order[i]));
            EXPECT_EQ(replay.list_calls[i].list, lists.list(layout[order[i]].mesh));
            const glm::dmat4 expected(matrices.mesh(order[i]));
            for (int column = 0; column < 4; ++column) {
                for (int row = 0; row < 4; ++row) {
                    // glRotatef takes degrees in float: 180 of them are off by up to 7.6e-6 degrees, which
                    // 10 m away is 1.4e-6 m; part_matrices rounds to float besides.
                    EXPECT_NEAR(replay.list_calls[i].modelview[column][row], expected[column][row], 4e-6);
                }
            }
        }
    }

    scene::TankLists lists;
    tank::Layout layout = tank::default_layout();
    tank::JointAngles joints;
    collision::PartSet parts = all_parts();
};

TEST_F(DrawTank, PutsEveryPartWherePartMatricesPutIt)
{
    std::mt19937 random(7);
    for (int pose = 0; pose < 200; ++pose) {
        for (double& angle : joints.radians) {
            angle = static_cast<double>(random()) / 4294967296.0 * 6.28 - 3.14;
        }
        const glm::vec3 position(static_cast<float>(pose % 5), static_cast<float>(pose % 3), -3.5f);
        expect_part_matrices(draw(position.x, position.y, position.z), position);
        if (HasFailure()) {
            break;
        }
    }
}

TEST_F(DrawTank, DrawsTheLinksOfEachSideWithTheBodyWhereItsWheelsHaveTurnedThem)
{
    const assets::Assets with_links = scene_test::assets_with_links();
    ASSERT_TRUE(lists.load_tank_objs(with_links.high, with_links.track_links));
    recording_gl::take_calls();
    const double pitch = 2.0 * std::numbers::pi / with_links.track_links.per_turn;
    joints[Joint::heading] = 0.7;
    joints[Joint::wheels_left] = 0.3 * pitch;
    joints[Joint::wheels_right] = -0.4 * pitch;
    const recording_gl::Replay replay = recording_gl::replay(draw(1.0f, 0.0f, 2.0f));
    ASSERT_EQ(replay.list_calls.size(), tank::PART_COUNT + 2);
    EXPECT_LE(replay.list_calls.size(), 25u); // draw calls that a tank may take
    EXPECT_EQ(replay.list_calls[0].list, lists.list(tank::MeshKind::body));
    EXPECT_EQ(replay.list_calls[1].list, lists.track_list(assets::Side::left, 0.3 * pitch));
    EXPECT_EQ(replay.list_calls[2].list, lists.track_list(assets::Side::right, -0.4 * pitch));
    EXPECT_NE(replay.list_calls[1].list, lists.track_list(assets::Side::left, 0.0));
    EXPECT_NE(replay.list_calls[2].list, lists.track_list(assets::Side::right, 0.0));
    EXPECT_EQ(replay.list_calls[1].modelview, replay.list_calls[0].modelview);
    EXPECT_EQ(replay.list_calls[2].modelview, replay.list_calls[0].modelview);
}

TEST_F(DrawTank, FollowsATreeOfAnyShape)
{
    joints[Joint::turret] = 0.5;
    joints[Joint::main_gun] = 0.25;
    layout[Part::secondary_gun].parent = Part::main_gun;
    layout[Part::wheel_left_2].parent = Part::turret;
    layout[Part::wheel_right_1].mesh_offset = {0.1f, 0.2f, 0.3f};
    layout[Part::main_gun].mesh_yaw = 0.75;
    expect_part_matrices(draw(0.0f, 0.0f, 0.0f), {0.0, 0.0, 0.0});
}

TEST_F(DrawTank, LeavesTheMatrixStackAsItWas)
{
    const recording_gl::Replay replay = recording_gl::replay(draw(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(replay.final_stack_depth, 0u);
    EXPECT_FALSE(replay.popped_too_often);
}

TEST_F(DrawTank, StaysWithinTheStackThatOpenGlPromises)
{
    for (const recording_gl::ListCall& call : recording_gl::replay(draw(0.0f, 0.0f, 0.0f)).list_calls) {
        EXPECT_LE(call.stack_depth, 31u); // GL_MAX_MODELVIEW_STACK_DEPTH is at least 32
    }
}

TEST_F(DrawTank, GivesNoVertexAndNoMatrixOfItsOwn)
{
    const std::vector<std::string> allowed = {"glPushMatrix", "glPopMatrix", "glTranslate", "glRotate",
                                              "glCallList"};
    for (const Call& call : draw(0.0f, 0.0f, 0.0f)) {
        EXPECT_NE(std::find(allowed.begin(), allowed.end(), call.name), allowed.end()) << call.name;
    }
}

TEST_F(DrawTank, CallsOneListForEachPart)
{
    std::map<unsigned, int> calls;
    for (const recording_gl::ListCall& call : recording_gl::replay(draw(0.0f, 0.0f, 0.0f)).list_calls) {
        ++calls[call.list];
    }
    EXPECT_EQ(calls.size(), tank::MESH_KIND_COUNT);
    EXPECT_EQ(calls[lists.list(tank::MeshKind::body)], 1);
    EXPECT_EQ(calls[lists.list(tank::MeshKind::turret)], 1);
    EXPECT_EQ(calls[lists.list(tank::MeshKind::main_gun)], 1);
    EXPECT_EQ(calls[lists.list(tank::MeshKind::secondary_gun)], 1);
    EXPECT_EQ(calls[lists.list(tank::MeshKind::wheel)], 14);
}

TEST_F(DrawTank, PutsTheLowTanksPartsWhereTheHighOnesAre)
{
    joints.radians = {0.3, -0.8, 0.2, 1.1, 0.6, 2.0, -2.0};
    const recording_gl::Replay high = recording_gl::replay(draw(1.0f, 0.5f, -3.5f));
    const recording_gl::Replay low = recording_gl::replay(draw_low(1.0f, 0.5f, -3.5f));
    const std::vector<Part> order = order_of(layout);
    ASSERT_EQ(low.list_calls.size(), high.list_calls.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        EXPECT_EQ(lists.low_mesh_of(low.list_calls[i].list), layout[order[i]].mesh);
        EXPECT_EQ(low.list_calls[i].modelview, high.list_calls[i].modelview);
    }
    EXPECT_EQ(low.final_stack_depth, 0u);
    EXPECT_FALSE(low.popped_too_often);
}

TEST_F(DrawTank, DrawsTheLowTankUnlitAndUntextured)
{
    glEnable(GL_LIGHTING);
    glEnable(GL_TEXTURE_2D);
    const recording_gl::Replay low = recording_gl::replay(draw_low(0.0f, 0.0f, 0.0f));
    ASSERT_EQ(low.list_calls.size(), tank::PART_COUNT);
    for (const recording_gl::ListCall& call : low.list_calls) {
        EXPECT_FALSE(call.is_enabled(GL_LIGHTING));
        EXPECT_FALSE(call.is_enabled(GL_TEXTURE_2D));
    }
}

TEST_F(DrawTank, TakesTheLowListsForHowEachMeshStandsToTheSun)
{
    joints[Joint::heading] = 0.5;
    joints[Joint::turret] = 1.0;
    joints[Joint::main_gun] = 0.3;
    joints[Joint::secondary_gun] = 2.0;
    joints[Joint::secondary_gun_pitch] = 1.0;
    joints[Joint::wheels_left] = 1.5;
    const recording_gl::Replay low = recording_gl::replay(draw_low(0.0f, 0.0f, 0.0f));
    const std::vector<Part> order = order_of(layout);
    ASSERT_EQ(low.list_calls.size(), order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        // What turns about another axis than +Y, or about none, makes no difference.
        double yaw = 0.5;
        yaw += order[i] == Part::turret || order[i] == Part::main_gun ? 1.0 : 0.0;
        yaw += order[i] == Part::secondary_gun ? 3.0 : 0.0;
        yaw += order[i] >= Part::wheel_right_1 ? std::numbers::pi : 0.0;
        EXPECT_EQ(low.list_calls[i].list, lists.low_list(layout[order[i]].mesh, yaw))
            << tank::part_name(order[i]);
    }
}

TEST_F(DrawTank, LeavesLightTextureAndColourAsTheyWereAfterTheLowTank)
{
    glEnable(GL_LIGHTING);
    glEnable(GL_TEXTURE_2D);
    glColor3ub(255, 255, 255);
    const std::vector<Call> before = recording_gl::calls();
    const recording_gl::Replay after = recording_gl::replay(draw_low(0.0f, 0.0f, 0.0f));
    EXPECT_EQ(after.final_enabled, recording_gl::replay(before).final_enabled);
    EXPECT_EQ(after.final_settings, recording_gl::replay(before).final_settings);
}

TEST_F(DrawTank, DrawsOnlyThePartsAskedForAndWhereTheyHang)
{
    joints.radians = {0.3, -0.8, 0.2, 1.1, 0.6, 2.0, -2.0};
    const recording_gl::Replay all = recording_gl::replay(draw(0.0f, 0.0f, 0.0f));
    const std::vector<Part> order = order_of(layout);
    for (std::size_t i = 0; i < order.size(); ++i) {
        parts = collision::PartSet(std::uint64_t{1} << tank::index_of(order[i]));
        const recording_gl::Replay one = recording_gl::replay(draw(0.0f, 0.0f, 0.0f));
        ASSERT_EQ(one.list_calls.size(), 1u);
        EXPECT_EQ(one.list_calls[0].list, all.list_calls[i].list);
        EXPECT_EQ(one.list_calls[0].modelview, all.list_calls[i].modelview);
        EXPECT_EQ(one.final_stack_depth, 0u);
    }
}

} // namespace
