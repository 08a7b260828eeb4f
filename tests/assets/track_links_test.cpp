#include "assets/track_links.h"

#include "asset_fixtures.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace assets {
namespace {

constexpr int COUNT = 12;
constexpr double RADIUS = 0.5;

glm::vec3 on_circle(double links, double x)
{
    const double angle = 2.0 * std::numbers::pi * links / COUNT;
    return {x, RADIUS * std::sin(angle), RADIUS * std::cos(angle)};
}

void add_face(mesh::ObjMesh& mesh, const std::array<glm::vec3, 3>& corners)
{
    mesh::Face face{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto index = static_cast<int>(mesh.positions.size());
        face.vertices[i] = {.position = index, .normal = index, .texture_coordinate = 0};
        mesh.positions.push_back(corners[i]);
        mesh.normals.push_back({0.0f, corners[i].y, corners[i].z});
    }
    mesh.faces.push_back(face);
}

/// A face that rests, then a belt of COUNT links on each side, one or two faces a link, each link beginning
/// where the one before ends.
mesh::ObjMesh belts()
{
    mesh::ObjMesh mesh;
    mesh.texture_coordinates = {{0.25f, 0.75f}};
    add_face(mesh, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    for (const auto& [name, x, faces] :
         {std::tuple("left_belt_", 1.0, 1), std::tuple("right_belt_", -1.0, 2)}) {
        for (int link = 0; link < COUNT; ++link) {
            mesh.groups.push_back({name + std::to_string(link), static_cast<int>(mesh.faces.size()), faces});
            for (int face = 0; face < faces; ++face) {
                add_face(mesh, {on_circle(link, x), on_circle(link + 1, x), on_circle(link, x + 0.1 + face)});
            }
        }
    }
    return mesh;
}

glm::vec3 corner(const mesh::ObjMesh& mesh, std::size_t face, std::size_t index)
{
    return mesh.positions[static_cast<std::size_t>(mesh.faces[face].vertices[index].position)];
}

TEST(TrackLinks, AreTheGroupsThatFollowEachOtherOnASide)
{
    const TrackLinks links = find_track_links(belts(), RADIUS);
    ASSERT_TRUE(links.any());
    EXPECT_EQ(links.resting, std::vector<int>{0});
    ASSERT_EQ(links.moving[0].size(), std::size_t{COUNT});
    ASSERT_EQ(links.moving[1].size(), std::size_t{2 * COUNT});
    const LinkFace& first = links.moving[0].front();
    EXPECT_EQ((std::array{first.previous, first.here, first.next, first.after_next}),
              (std::array{COUNT, 1, 2, 3}));
    const LinkFace& last = links.moving[1].back();
    const int end = static_cast<int>(belts().faces.size()) - 1;
    EXPECT_EQ((std::array{last.previous, last.here, last.next, last.after_next}),
              (std::array{end - 2, end, COUNT + 2, COUNT + 4}));
}

TEST(TrackLinks, RestWhereAChainIsNotWhole)
{
    const auto expect_only_right = [](const mesh::ObjMesh& mesh) {
        const TrackLinks links = find_track_links(mesh, RADIUS);
        EXPECT_TRUE(links.moving[0].empty());
        EXPECT_EQ(links.moving[1].size(), std::size_t{2 * COUNT});
        EXPECT_EQ(links.resting.size(), std::size_t{1 + COUNT});
    };
    mesh::ObjMesh gap = belts();
    gap.groups[5].name = "left_belt_99";
    expect_only_right(gap);
    mesh::ObjMesh doubled = belts();
    doubled.groups[5].name = "left_belt_4";
    expect_only_right(doubled);
    mesh::ObjMesh uneven = belts();
    uneven.groups[5].face_count = 2;
    expect_only_right(uneven);
    mesh::ObjMesh short_chain = belts();
    for (std::size_t i = 2; i < COUNT; ++i) {
        short_chain.groups[i].name = "hull";
    }
    expect_only_right(short_chain);
}

TEST(TrackLinks, AreNoneInAMeshWithoutSuchGroupsOrWithoutWheels)
{
    mesh::ObjMesh other = belts();
    other.groups = {{"left_", 0, 1},        {"left_belt", 1, 1},
                    {"belt_0", 2, 1},       {"left_belt_-1", 3, 1},
                    {"left_belt_1x", 4, 1}, {"left_belt_99999999999", 5, 1},
                    {"right", 6, 1},        {"_", 7, 1}};
    for (const TrackLinks& links : {find_track_links(other, RADIUS), find_track_links(belts(), 0.0)}) {
        EXPECT_FALSE(links.any());
        EXPECT_EQ(links.resting.size(), belts().faces.size());
        EXPECT_TRUE(links.moving[0].empty() && links.moving[1].empty());
    }
}

TEST(TrackLinks, StandAtRestWhereTheMeshHasThemToTheBit)
{
    const mesh::ObjMesh body = belts();
    const TrackLinks links = find_track_links(body, RADIUS);
    const mesh::ObjMesh rest = moved_links(body, links, Side::right, 0.0);
    ASSERT_EQ(rest.faces.size(), std::size_t{2 * COUNT});
    for (std::size_t i = 0; i < rest.faces.size(); ++i) {
        const mesh::Face& wanted = body.faces[static_cast<std::size_t>(links.moving[1][i].here)];
        for (std::size_t c = 0; c < 3; ++c) {
            const mesh::FaceVertex& is = rest.faces[i].vertices[c];
            EXPECT_EQ(rest.positions[static_cast<std::size_t>(is.position)],
                      body.positions[static_cast<std::size_t>(wanted.vertices[c].position)]);
            EXPECT_EQ(rest.normals[static_cast<std::size_t>(is.normal)],
                      body.normals[static_cast<std::size_t>(wanted.vertices[c].normal)]);
            EXPECT_EQ(is.texture_coordinate, wanted.vertices[c].texture_coordinate);
        }
    }
    EXPECT_EQ(rest.texture_coordinates, body.texture_coordinates);
}

TEST(TrackLinks, RunOnTheirWayBetweenTheirNeighboursAndStayTogether)
{
    const mesh::ObjMesh body = belts();
    const TrackLinks links = find_track_links(body, RADIUS);
    for (const double way : {0.1, 0.5, 0.75}) {
        const mesh::ObjMesh moved = moved_links(body, links, Side::left, way);
        for (std::size_t i = 0; i < moved.faces.size(); ++i) {
            // The spline keeps to the circle within 0.2 % of its radius, and to the way's share of an arc.
            EXPECT_LT(glm::length(corner(moved, i, 0) - on_circle(static_cast<double>(i) + way, 1.0)), 0.005);
            EXPECT_NEAR(std::hypot(corner(moved, i, 0).y, corner(moved, i, 0).z), RADIUS, 0.002 * RADIUS);
            // Where one link ends, the next begins.
            EXPECT_EQ(corner(moved, i, 1), corner(moved, (i + 1) % moved.faces.size(), 0));
        }
    }
}

TEST(TrackLinks, LeaveTheRestOfTheMesh)
{
    const mesh::ObjMesh body = belts();
    const mesh::ObjMesh rest = without_links(body, find_track_links(body, RADIUS));
    EXPECT_EQ(rest.faces, std::vector<mesh::Face>{body.faces[0]});
    EXPECT_EQ(rest.positions, body.positions);
}

TEST(TrackLinks, FaceSomewhereAlsoHalfWayBetweenLinksThatFaceOppositeWays)
{
    mesh::ObjMesh body = belts();
    for (std::size_t i = 0; i < body.normals.size(); ++i) {
        body.normals[i] = {0.0f, (i / 3) % 2 == 0 ? 1.0f : -1.0f, 0.0f};
    }
    const mesh::ObjMesh moved = moved_links(body, find_track_links(body, RADIUS), Side::left, 0.5);
    for (const glm::vec3& normal : moved.normals) {
        EXPECT_GT(glm::length(normal), 0.5f);
    }
}

TEST(TrackLinks, PassByTheWheelsAngleAsAWholeNumberATurn)
{
    // A wheel as large as the belt's circle: the chords are a little shorter than the arcs, and 12 pass all
    // the same.
    const TrackLinks links = find_track_links(belts(), RADIUS);
    EXPECT_EQ(links.per_turn, COUNT);
    EXPECT_EQ(find_track_links(belts(), 2.0 * RADIUS).per_turn, 2 * COUNT);
    const double pitch = 2.0 * std::numbers::pi / COUNT;
    EXPECT_EQ(link_phase(links, 0.0, 8), 0u);
    EXPECT_EQ(link_phase(links, 0.25 * pitch, 8), 2u);
    EXPECT_EQ(link_phase(links, -0.25 * pitch, 8), 6u);
    EXPECT_EQ(link_phase(links, 0.99 * pitch, 8), 0u);
    EXPECT_EQ(link_phase(links, 5.5 * pitch, 8), 4u);
    // The wheels' angle wraps from pi to -pi, and the links do not jump.
    EXPECT_EQ(link_phase(links, std::numbers::pi - 0.3 * pitch, 8),
              link_phase(links, -std::numbers::pi - 0.3 * pitch, 8));
}

TEST(TrackLinks, OfOurTankKeepTheirFormAndThePlaceOfTheTrackOnTheirWay)
{
    const mesh::ObjMesh& body = own_assets().high[tank::index_of(tank::MeshKind::body)];
    const TrackLinks& links = own_assets().track_links;
    EXPECT_EQ(links.per_turn, 11);
    for (const Side side : {Side::left, Side::right}) {
        const mesh::ObjMesh rest = moved_links(body, links, side, 0.0);
        const mesh::ObjMesh moved = moved_links(body, links, side, 0.5);
        ASSERT_GT(rest.faces.size(), 1000u);
        for (std::size_t i = 0; i < moved.faces.size(); ++i) {
            // Half way between straight and round, an edge is a fifth longer or shorter at most.
            const float was = glm::length(corner(rest, i, 1) - corner(rest, i, 0));
            EXPECT_NEAR(glm::length(corner(moved, i, 1) - corner(moved, i, 0)), was, 0.2f * was + 0.005f);
            EXPECT_GT(corner(moved, i, 0).y, -0.01f);               // on the ground
            EXPECT_EQ(corner(moved, i, 0).x, corner(rest, i, 0).x); // to no side
            EXPECT_EQ(corner(moved, i, 0).x > 0.0f, side == Side::left);
        }
    }
}

} // namespace
} // namespace assets
