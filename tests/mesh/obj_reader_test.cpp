#include "mesh/obj_reader.h"
#include "tests/mesh/invariants.h"
#include "tests/mesh/sample_files.h"

#include <clocale>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace {

using mesh::FaceVertex;
using mesh::ObjMesh;

ObjMesh read(std::string_view text)
{
    base::Result<ObjMesh> result = mesh::read_obj("test.obj", text);
    EXPECT_TRUE(result) << (result ? "" : result.error().message());
    if (!result) {
        return {};
    }
    EXPECT_EQ(broken_invariant(result.value()), "");
    return std::move(result).value();
}

constexpr const char* corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// Reads the positions of a triangle whose third vertex is `vertex`, and returns that vertex.
glm::vec3 read_vertex(const std::string& vertex)
{
    const ObjMesh m = read("v 0 0 0\nv 1 0 0\n" + vertex + "\nf 1 2 3\n");
    return m.positions.size() == 3 ? m.positions[2] : glm::vec3(-1);
}

TEST(ReadObj, ReadsPositionsNormalsTextureCoordinatesAndFaces)
{
    const ObjMesh m = read("v 1 2 3\nv 4 5 6\nv 7 8 10\n"
                           "vt 0 0.25\nvt 0.5 1\n"
                           "vn 0 0 1\nvn 0 1 0\n"
                           "f 1/1/1 2/2/2 3/1/2\n");
    EXPECT_EQ(m.positions, (std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}));
    EXPECT_EQ(m.texture_coordinates, (std::vector<glm::vec2>{{0, 0.25f}, {0.5f, 1}}));
    EXPECT_EQ(m.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}}));
    ASSERT_EQ(m.faces.size(), 1U);
    EXPECT_EQ(m.faces[0].vertices[0], (FaceVertex{0, 0, 0}));
    EXPECT_EQ(m.faces[0].vertices[1], (FaceVertex{1, 1, 1}));
    EXPECT_EQ(m.faces[0].vertices[2], (FaceVertex{2, 1, 0}));
}

TEST(ReadObj, ReadsFacesOfPositionsAlone)
{
    const ObjMesh m = read(std::string(corner) + "f 3 1 2\n");
    EXPECT_EQ(m.faces[0].vertices[0].position, 2);
    EXPECT_EQ(m.faces[0].vertices[0].texture_coordinate, -1);
}

TEST(ReadObj, ReadsFacesOfPositionsAndTextureCoordinates)
{
    const ObjMesh m = read(std::string(corner) + "vt 0 0\nvt 1 1\nf 1/2 2/1 3/2\n");
    EXPECT_EQ(m.faces[0].vertices[0].texture_coordinate, 1);
    EXPECT_EQ(m.faces[0].vertices[1].texture_coordinate, 0);
}

TEST(ReadObj, ReadsFacesOfPositionsAndNormals)
{
    const ObjMesh m = read(std::string(corner) + "vn 0 0 1\nvn 0 0 2\nf 1//2 2//1 3//2\n");
    EXPECT_EQ(m.faces[0].vertices[0], (FaceVertex{0, 1, -1}));
    EXPECT_EQ(m.faces[0].vertices[1], (FaceVertex{1, 0, -1}));
}

TEST(ReadObj, AllowsEachFaceItsOwnForm)
{
    const ObjMesh m =
        read(std::string(corner) + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1 2 3\n");
    EXPECT_EQ(m.faces.size(), 3U);
}

TEST(ReadObj, CountsNegativeIndicesBackFromWhatWasReadSoFar)
{
    const ObjMesh m = read(std::string(corner) + "vt 0 0\nvt 1 0\nvn 0 0 1\nf -3/-2/-1 -2/-1/-1 -1/-1/-1\n" +
                           "v 5 5 5\nf -1/-1/-1 -2/-1/-1 -4/-2/-1\n");
    EXPECT_EQ(m.faces[0].vertices[0], (FaceVertex{0, 0, 0}));
    EXPECT_EQ(m.faces[0].vertices[2], (FaceVertex{2, 0, 1}));
    EXPECT_EQ(m.faces[1].vertices[0].position, 3);
    EXPECT_EQ(m.faces[1].vertices[2].position, 0);
}

TEST(ReadObj, ReadsEveryWayOfWritingANumber)
{
    EXPECT_EQ(read_vertex("v -1 +2 3."), glm::vec3(-1, 2, 3));
    EXPECT_EQ(read_vertex("v .5 -.25 1e1"), glm::vec3(0.5f, -0.25f, 10));
    EXPECT_EQ(read_vertex("v 1.5e-3 2E+2 1e0"), glm::vec3(1.5e-3f, 200, 1));
    EXPECT_EQ(read_vertex("v 000001 0.1000000000000000055511151231257827 1.e2"), glm::vec3(1, 0.1f, 100));
    EXPECT_EQ(read_vertex("v 3.4028234e38 -3.4028234e38 1e-40"),
              glm::vec3(3.4028234e38f, -3.4028234e38f, 1e-40F));
    EXPECT_EQ(read_vertex("v 0e400 1e-400 0.0"), glm::vec3(0));
}

TEST(ReadObj, DropsAWeightOrColourAfterAPosition)
{
    EXPECT_EQ(read_vertex("v 1 2 3 0.5"), glm::vec3(1, 2, 3));
    EXPECT_EQ(read_vertex("v 1 2 3 0.1 0.2 0.3"), glm::vec3(1, 2, 3));
    EXPECT_EQ(read_vertex("v 1 2 3 1.0 0.1 0.2 0.3"), glm::vec3(1, 2, 3));
}

TEST(ReadObj, ReadsOneTwoOrThreeTextureCoordinates)
{
    const ObjMesh m = read(std::string(corner) + "vt 0.5\nvt 0.5 0.25\nvt 0.5 0.75 1\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(m.texture_coordinates, (std::vector<glm::vec2>{{0.5f, 0}, {0.5f, 0.25f}, {0.5f, 0.75f}}));
}

TEST(ReadObj, ReadsEveryKindOfLineEnd)
{
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const ObjMesh m = read("v 0 0 0" + end + "v 1 0 0" + end + end + "v 0 1 0" + end + "f 1 2 3" + end);
        EXPECT_EQ(m.positions.size(), 3U);
        EXPECT_EQ(m.faces.size(), 1U);
    }
}

TEST(ReadObj, ReadsALastLineWithoutAnEnd)
{
    EXPECT_EQ(read(std::string(corner) + "f 1 2 3").faces.size(), 1U);
}

TEST(ReadObj, ReadsTabsAndSpacesAnywhereBetweenWords)
{
    EXPECT_EQ(read_vertex(" \t v\t1  2 \t3\t "), glm::vec3(1, 2, 3));
}

TEST(ReadObj, ContinuesALineAfterABackslash)
{
    EXPECT_EQ(read_vertex("v 1 \\\n 2 \\\r\n3"), glm::vec3(1, 2, 3));
    EXPECT_EQ(read_vertex("v 1\\\n2\\\n3"), glm::vec3(1, 2, 3));
    EXPECT_EQ(read(std::string(corner) + "f 1 \\\n2 \\\n3 \\").faces.size(), 1U);
}

TEST(ReadObj, SkipsComments)
{
    EXPECT_EQ(read_vertex("# v 9 9 9\n  # another\nv 1 2 3 # and one behind\n#"), glm::vec3(1, 2, 3));
}

TEST(ReadObj, DoesNotContinueACommentThatEndsInABackslash)
{
    EXPECT_EQ(read_vertex("# from C:\\models\\\nv 1 2 3"), glm::vec3(1, 2, 3));
}

TEST(ReadObj, ToleratesStatementsItDoesNotUse)
{
    const ObjMesh m = read("mtllib a b.mtl\no Tank\ng left wheel\nusemtl\nvp 1 2\nl 1 2\np 1\ncstype bezier\n"
                           "curv 0 1 \\\n 2 3\nlod 1\nshadow_obj x\nv1 bogus\n\xC3\xA4\xC3\xB6 text\n" +
                           std::string(corner) + "s\ns off\nf 1 2 3\nend");
    EXPECT_EQ(m.positions.size(), 3U);
    EXPECT_EQ(m.faces.size(), 1U);
}

TEST(ReadObj, SkipsAByteOrderMarkAndADosEndOfFile)
{
    EXPECT_EQ(read("\xEF\xBB\xBFv 5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\x1A").positions[0].x, 5);
}

TEST(ReadObj, ReadsDecimalPointsInALocaleWithCommas)
{
    bool found = false;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "sv_SE.UTF-8"}) {
        found = found || std::setlocale(LC_NUMERIC, name) != nullptr;
    }
    if (!found) {
        GTEST_SKIP() << "no locale with a decimal comma is installed";
    }
    EXPECT_EQ(read_vertex("v 1.5 2.25 1e-1"), glm::vec3(1.5f, 2.25f, 0.1f));
    std::setlocale(LC_NUMERIC, "C");
}

TEST(ReadObj, KeepsTheGroupsOfFacesInTheirOrder)
{
    const ObjMesh m = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                           "f 1 2 3\n"
                           "g track_0 moving\nf 1 2 3\nf 1 2 4 3\n"
                           "g track_1\nf 2 3 1\ng track_1\nf 3 2 1\n"
                           "g\nf 1 2 3\n"
                           "g empty\ng track_0\nf 2 4 3\n");
    EXPECT_EQ(m.faces.size(), 8u);
    EXPECT_EQ(m.groups,
              (std::vector<mesh::FaceGroup>{{"track_0", 1, 3}, {"track_1", 4, 2}, {"track_0", 7, 1}}));
}

TEST(ReadObj, KeepsGivenNormalsAsTheyAre)
{
    const ObjMesh m = read(std::string(corner) + "vn 0 0 0.2\nvn 3 2 1\nvn -1 0 0\nf 1//1 2//2 3//3\n");
    EXPECT_EQ(m.normals, (std::vector<glm::vec3>{{0, 0, 0.2f}, {3, 2, 1}, {-1, 0, 0}}));
}

TEST(ReadObj, KeepsATriangleWithoutArea)
{
    const ObjMesh m = read("v 1 1 1\nf 1 1 1\n");
    ASSERT_EQ(m.faces.size(), 1U);
    EXPECT_EQ(m.normals, (std::vector<glm::vec3>{{0, 1, 0}}));
}

TEST(ReadObj, CutsAConcavePolygonInsideItsOutline)
{
    // An L, seen from +Z; a fan from its first corner would cover what is outside.
    const ObjMesh m = read("v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6\n");
    ASSERT_EQ(m.faces.size(), 4U);
    float area = 0;
    for (const mesh::Face& face : m.faces) {
        const glm::vec3 a = m.positions[face.vertices[0].position];
        const glm::vec3 b = m.positions[face.vertices[1].position];
        const glm::vec3 c = m.positions[face.vertices[2].position];
        const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        EXPECT_GE(twice, 0);
        area += twice / 2;
    }
    EXPECT_EQ(area, 3);
    EXPECT_EQ(m.normals, (std::vector<glm::vec3>{{0, 0, 1}}));
}

TEST(ReadObj, KeepsTheIndicesOfEachCornerWhenItCutsAPolygon)
{
    const ObjMesh m = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                           "f 1/4/1 2/3/1 3/2/1 4/1/1\n");
    ASSERT_EQ(m.faces.size(), 2U);
    for (const mesh::Face& face : m.faces) {
        for (const FaceVertex& v : face.vertices) {
            EXPECT_EQ(v.position + v.texture_coordinate, 3);
        }
    }
}

TEST(ReadObj, ReadsACubeThatWasWritten)
{
    const ObjMesh m = read(sample_obj());
    EXPECT_EQ(m.positions.size(), 8U);
    EXPECT_EQ(m.texture_coordinates.size(), 4U);
    EXPECT_EQ(m.normals.size(), 6U);
    ASSERT_EQ(m.faces.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
        for (const FaceVertex& v : m.faces[i].vertices) {
            EXPECT_EQ(v.normal, int(i / 2));
            // On face n of the cube, the position lies in the direction of the normal.
            EXPECT_EQ(glm::dot(m.positions[v.position], m.normals[v.normal]), 1);
        }
    }
    EXPECT_EQ(broken_invariant(read(written_obj(m))), "");
    EXPECT_EQ(read(written_obj(m)).faces, m.faces);
    EXPECT_EQ(read(written_obj(m)).positions, m.positions);
}

} // namespace
