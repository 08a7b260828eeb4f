#include "scene/tank/tank_lists.h"

#include "fixtures.h"
#include "recording_gl.h"

#include <algorithm>
#include <numbers>
#include <set>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;
using tank::MeshKind;

std::vector<Call> named(const std::vector<Call>& calls, std::string_view name)
{
    std::vector<Call> found;
    for (const Call& call : calls) {
        if (call.name == name) {
            found.push_back(call);
        }
    }
    return found;
}

TEST(TankLists, AreFiveFromOneGlGenLists)
{
    recording_gl::reset();
    scene::TankLists lists;
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    const std::vector<Call> generated = named(recording_gl::calls(), "glGenLists");
    ASSERT_EQ(generated.size(), 1u);
    EXPECT_EQ(generated[0].arguments[0], 5.0);
    EXPECT_EQ(named(recording_gl::calls(), "glEndList").size(), 5u);
}

TEST(TankLists, HoldEachMeshUnderItsOwnName)
{
    recording_gl::reset();
    scene::TankLists lists;
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    std::set<unsigned> names;
    for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
        const unsigned list = lists.list(static_cast<MeshKind>(mesh));
        names.insert(list);
        std::size_t vertices = 0;
        for (const Call& call : named(recording_gl::calls(), "glVertex3f")) {
            vertices += call.compiled_into == list ? 1u : 0u;
        }
        EXPECT_EQ(vertices, 3 * (mesh + 1)); // the fixture's meshes have 1, 2 ... 5 faces
    }
    EXPECT_EQ(names.size(), 5u);
    EXPECT_EQ(names.count(0), 0u);
}

TEST(TankLists, AreCompiledAndNotDrawn)
{
    recording_gl::reset();
    scene::TankLists lists;
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    for (const Call& call : named(recording_gl::calls(), "glNewList")) {
        EXPECT_EQ(call.arguments[1], GL_COMPILE);
    }
    for (const Call& call : named(recording_gl::calls(), "glVertex3f")) {
        EXPECT_NE(call.compiled_into, 0u);
    }
}

TEST(TankLists, LoadedAgainReplaceTheOldOnes)
{
    recording_gl::reset();
    scene::TankLists lists;
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    const unsigned old = lists.list(MeshKind::body);
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    const std::vector<Call> deleted = named(recording_gl::calls(), "glDeleteLists");
    ASSERT_EQ(deleted.size(), 1u);
    EXPECT_EQ(deleted[0].arguments, (std::vector<double>{static_cast<double>(old), 5.0}));
}

std::size_t vertices_of(unsigned list)
{
    const std::vector<Call> vertices = named(recording_gl::calls(), "glVertex3f");
    return static_cast<std::size_t>(std::count_if(
        vertices.begin(), vertices.end(), [&](const Call& call) { return call.compiled_into == list; }));
}

TEST(TankLists, OfABodyWithLinksHaveThemOnTheirWayInListsOfTheirOwn)
{
    recording_gl::reset();
    const assets::Assets assets = scene_test::assets_with_links();
    scene::TankLists lists;
    ASSERT_TRUE(lists.load_tank_objs(assets.high, assets.track_links));
    EXPECT_EQ(vertices_of(lists.list(MeshKind::body)), 3u); // the face that rests
    const double pitch = 2.0 * std::numbers::pi / assets.track_links.per_turn;
    std::set<unsigned> names;
    for (const assets::Side side : {assets::Side::left, assets::Side::right}) {
        for (int step = 0; step < 100; ++step) {
            const unsigned list = lists.track_list(side, pitch * (step / 100.0 + 0.003));
            EXPECT_TRUE(lists.is_track_list(list));
            EXPECT_EQ(list, lists.track_list(side, pitch * (step / 100.0 - 1.997)));
            EXPECT_EQ(vertices_of(list), 9u); // three links
            names.insert(list);
        }
    }
    EXPECT_EQ(names.count(0), 0u);
    EXPECT_GE(names.size(), 2u * 8u); // steps of a pitch
    EXPECT_FALSE(lists.is_track_list(lists.list(MeshKind::body)));
    EXPECT_FALSE(lists.is_track_list(0));
}

TEST(TankLists, OfABodyWithoutLinksAreNoMore)
{
    recording_gl::reset();
    scene::TankLists lists;
    const assets::Assets with = scene_test::assets_with_links();
    ASSERT_TRUE(lists.load_tank_objs(with.high, with.track_links));
    const unsigned old = lists.track_list(assets::Side::left, 0.0);
    recording_gl::take_calls();
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    EXPECT_EQ(lists.track_list(assets::Side::left, 0.0), 0u);
    EXPECT_FALSE(lists.is_track_list(old));
    EXPECT_EQ(named(recording_gl::calls(), "glEndList").size(), 5u);
    EXPECT_EQ(named(recording_gl::calls(), "glDeleteLists").size(), 2u);
}

TEST(TankLists, OfTheLowTankAreOthersForEachMeshAndWayItStandsToTheSun)
{
    recording_gl::reset();
    scene::TankLists lists;
    ASSERT_TRUE(lists.load_tank_objs(scene_test::assets().high));
    EXPECT_EQ(lists.low_list(MeshKind::body, 0.0), 0u);
    ASSERT_TRUE(lists.load_low_detail_tank_objs(scene_test::assets().low));
    std::set<unsigned> names;
    for (std::size_t i = 0; i < tank::MESH_KIND_COUNT; ++i) {
        const auto mesh = static_cast<MeshKind>(i);
        EXPECT_EQ(lists.low_mesh_of(lists.list(mesh)), std::nullopt);
        for (int yaw = -360; yaw <= 720; yaw += 5) {
            const double radians = yaw * std::numbers::pi / 180.0;
            const unsigned low = lists.low_list(mesh, radians);
            names.insert(low);
            EXPECT_EQ(lists.low_mesh_of(low), mesh);
            EXPECT_EQ(lists.low_list(mesh, radians + 2.0 * std::numbers::pi), low) << yaw;
            EXPECT_NE(lists.low_list(mesh, radians + 0.5), low) << yaw;
        }
        const unsigned low = lists.low_list(mesh, 0.1);
        std::size_t vertices = 0;
        for (const Call& call : named(recording_gl::calls(), "glVertex3f")) {
            vertices += call.compiled_into == low ? 1u : 0u;
        }
        EXPECT_EQ(vertices, 3u); // the fixture's low meshes have one face
    }
    EXPECT_EQ(names.size(), 5u * 24u);
    EXPECT_EQ(names.count(0), 0u);
    EXPECT_EQ(lists.low_mesh_of(0), std::nullopt);
}

TEST(TankLists, SayWhenThereAreNoNamesLeft)
{
    recording_gl::reset();
    recording_gl::have_no_list_names();
    scene::TankLists lists;
    EXPECT_FALSE(lists.load_tank_objs(scene_test::assets().high));
    EXPECT_EQ(lists.list(MeshKind::body), 0u);
    EXPECT_EQ(lists.list(MeshKind::wheel), 0u);
}

} // namespace
