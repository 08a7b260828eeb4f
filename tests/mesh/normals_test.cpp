#include "mesh/normals.h"
#include "mesh/obj_reader.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace {

using mesh::ObjMesh;

ObjMesh read(const std::string& text)
{
    base::Result<ObjMesh> result = mesh::read_obj("test.obj", text);
    EXPECT_TRUE(result) << (result ? "" : result.error().message());
    return result ? std::move(result).value() : ObjMesh{};
}

glm::vec3 normal_at(const ObjMesh& m, std::size_t face, std::size_t corner)
{
    return m.normals[m.faces[face].vertices[corner].normal];
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected)
{
    EXPECT_LT(glm::length(actual - expected), 1e-6F)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " is not " << expected.x << ' ' << expected.y
        << ' ' << expected.z;
}

/// Two squares of side 1 that meet at a right angle along the Y axis: one looks along +Z, the other along +X.
const std::string two_squares = "v -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nv 0 0 -1\nv 0 1 -1\n";
constexpr const char* both_faces = "f 1 2 3 4\nf 2 5 6 3\n";

TEST(CompleteNormals, GivesEachFlatPolygonOneNormalOfItsOwn)
{
    const ObjMesh m = read(two_squares + both_faces);
    EXPECT_EQ(m.normals, (std::vector<glm::vec3>{{0, 0, 1}, {1, 0, 0}}));
    for (std::size_t corner = 0; corner < 3; ++corner) {
        EXPECT_EQ(m.faces[0].vertices[corner].normal, 0);
        EXPECT_EQ(m.faces[1].vertices[corner].normal, 0);
        EXPECT_EQ(m.faces[2].vertices[corner].normal, 1);
    }
}

TEST(CompleteNormals, IsFlatWithSmoothingOffOrUnreadable)
{
    for (const std::string off : {"s off\n", "s 0\n", "s\n", "s none\n", "s 1\ns off\n", "s -1\n"}) {
        EXPECT_EQ(read(two_squares + off + both_faces).normals.size(), 2U) << off;
    }
}

TEST(CompleteNormals, MeansTheNormalsThatMeetInASmoothingGroup)
{
    const ObjMesh m = read(two_squares + "s 1\n" + both_faces);
    const float half = std::sqrt(0.5f);
    for (std::size_t face = 0; face < m.faces.size(); ++face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const bool on_edge = m.positions[m.faces[face].vertices[corner].position].x == 0 &&
                                 m.positions[m.faces[face].vertices[corner].position].z == 0;
            const glm::vec3 own = face < 2 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
            expect_near(normal_at(m, face, corner), on_edge ? glm::vec3(half, 0, half) : own);
        }
    }
}

TEST(CompleteNormals, SharesOneNormalAmongTheCornersThatMeet)
{
    EXPECT_EQ(read(two_squares + "s 1\n" + both_faces).normals.size(), 6U);
}

TEST(CompleteNormals, KeepsAnEdgeBetweenTwoSmoothingGroupsSharp)
{
    const ObjMesh m = read(two_squares + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n");
    for (std::size_t face = 0; face < 4; ++face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            expect_near(normal_at(m, face, corner), face < 2 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
        }
    }
}

TEST(CompleteNormals, CarriesASmoothingGroupOverGroupsAndObjects)
{
    EXPECT_EQ(read(two_squares + "s 1\nf 1 2 3 4\ng other\no other\nf 2 5 6 3\n").normals.size(), 6U);
}

TEST(CompleteNormals, WeighsByAngleSoThatTheCuttingOfPolygonsDoesNotMatter)
{
    // At a cube's corner three squares meet; cut into triangles, one of them may have two there.
    const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nv 1 0 1\nv 0 1 1\ns 1\n";
    const ObjMesh quads = read(corner + "f 1 3 5 2\nf 1 4 7 3\nf 1 2 6 4\n");
    const ObjMesh triangles = read(corner + "f 1 3 5\nf 1 5 2\nf 4 7 3\nf 1 4 3\nf 1 2 4\nf 2 6 4\n");
    const glm::vec3 outwards = glm::vec3(-1) / std::sqrt(3.0f);
    expect_near(normal_at(quads, 0, 0), outwards);
    expect_near(normal_at(triangles, 0, 0), outwards);
}

TEST(CompleteNormals, FallsBackToTheTrianglesNormalWhereTheMeanVanishes)
{
    const ObjMesh m = read("v 0 0 0\nv 1 0 0\nv 0 1 0\ns 1\nf 1 2 3\nf 3 2 1\n");
    for (std::size_t corner = 0; corner < 3; ++corner) {
        expect_near(normal_at(m, 0, corner), {0, 0, 1});
        expect_near(normal_at(m, 1, corner), {0, 0, -1});
    }
}

TEST(CompleteNormals, PointsUpWhereThereIsNoArea)
{
    for (const std::string smoothing : {"", "s 1\n"}) {
        const ObjMesh m = read("v 0 0 0\nv 1 1 1\nv 2 2 2\n" + smoothing + "f 1 2 3\n");
        for (std::size_t corner = 0; corner < 3; ++corner) {
            EXPECT_EQ(normal_at(m, 0, corner), glm::vec3(0, 1, 0));
        }
    }
}

TEST(CompleteNormals, ReplacesAZeroNormalByThatOfTheFace)
{
    for (const std::string smoothing : {"", "s 1\n"}) {
        const ObjMesh m = read(two_squares + "vn 0 0 0\nvn 0 2 0\n" + smoothing +
                               "f 1//1 2//2 3//1 4//2\nf 2//1 5//1 6//1 3//1\n");
        EXPECT_EQ(normal_at(m, 0, 0), glm::vec3(0, 0, 1));
        EXPECT_EQ(normal_at(m, 0, 1), glm::vec3(0, 2, 0));
        EXPECT_EQ(normal_at(m, 0, 2), glm::vec3(0, 0, 1));
        EXPECT_EQ(normal_at(m, 2, 0), glm::vec3(1, 0, 0));
        EXPECT_EQ(m.normals[0], glm::vec3(0)); // the array keeps what was given
    }
}

TEST(CompleteNormals, ReplacesNormalsThatCannotBeNormalisedInFloat)
{
    const ObjMesh m =
        read(two_squares + "vn 0 1e-20 0\nvn 0 1e20 0\nvn 0 1e-18 0\nvn 0 1e18 0\nf 1//1 2//2 3//3 4//4\n");
    EXPECT_EQ(normal_at(m, 0, 0), glm::vec3(0, 0, 1));
    EXPECT_EQ(normal_at(m, 0, 1), glm::vec3(0, 0, 1));
    EXPECT_EQ(normal_at(m, 0, 2), glm::vec3(0, 1e-18F, 0));
    EXPECT_EQ(normal_at(m, 1, 2), glm::vec3(0, 1e18F, 0));
}

TEST(CompleteNormals, LetsNormalsThatFollowKeepTheirNumbers)
{
    const ObjMesh m = read(two_squares + "vn 0 2 0\nf 1 2 3 4\nvn 0 0 3\nf 2//2 5//1 6//-1 3//-2\n");
    EXPECT_EQ(normal_at(m, 0, 0), glm::vec3(0, 0, 1));
    EXPECT_EQ(normal_at(m, 2, 0), glm::vec3(0, 0, 3));
    EXPECT_EQ(normal_at(m, 2, 1), glm::vec3(0, 2, 0));
    EXPECT_EQ(normal_at(m, 2, 2), glm::vec3(0, 0, 3));
}

TEST(CompleteNormals, StaysFiniteForTheLargestAndSmallestPositions)
{
    for (const std::string size : {"3.4e38", "1e-38", "1.5e-45"}) {
        for (const std::string smoothing : {"", "s 1\n"}) {
            const ObjMesh m =
                read("v 0 0 0\nv " + size + " 0 0\nv 0 0 -" + size + "\n" + smoothing + "f 1 2 3\n");
            expect_near(normal_at(m, 0, 0), {0, 1, 0});
        }
    }
}

TEST(CompleteNormals, SmoothsAHundredThousandFacesAroundOneVertexInGoodTime)
{
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 100'000; ++i) {
        text += "s " + std::to_string(1 + i) + "\nf 1 2 3\n";
    }
    EXPECT_EQ(read(text).normals.size(), 300'000U);
}

} // namespace
