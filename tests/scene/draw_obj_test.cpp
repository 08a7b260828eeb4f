#include "scene/tank/draw_obj.h"

#include "fixtures.h"
#include "recording_gl.h"

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::Call;

TEST(DrawObj, GivesEachCornerByItsThreeIndices)
{
    const mesh::ObjMesh obj = scene_test::mesh_of(4);
    recording_gl::reset();
    scene::draw_obj(obj);

    const std::vector<Call>& calls = recording_gl::calls();
    ASSERT_EQ(calls.size(), 2 + 4 * 3 * 3u);
    EXPECT_EQ(calls.front().name, "glBegin");
    EXPECT_EQ(calls.front().arguments[0], GL_TRIANGLES);
    EXPECT_EQ(calls.back().name, "glEnd");
    std::size_t at = 1;
    for (const mesh::Face& face : obj.faces) {
        for (const mesh::FaceVertex& corner : face.vertices) {
            const auto normal = glm::dvec3(obj.normals[static_cast<std::size_t>(corner.normal)]);
            const auto texture =
                glm::dvec2(obj.texture_coordinates[static_cast<std::size_t>(corner.texture_coordinate)]);
            const auto position = glm::dvec3(obj.positions[static_cast<std::size_t>(corner.position)]);
            EXPECT_EQ(calls[at].name, "glNormal3f");
            EXPECT_EQ(calls[at].arguments, (std::vector<double>{normal.x, normal.y, normal.z}));
            EXPECT_EQ(calls[at + 1].name, "glTexCoord2f");
            EXPECT_EQ(calls[at + 1].arguments, (std::vector<double>{texture.x, texture.y}));
            EXPECT_EQ(calls[at + 2].name, "glVertex3f"); // last: it takes what was given before
            EXPECT_EQ(calls[at + 2].arguments, (std::vector<double>{position.x, position.y, position.z}));
            at += 3;
        }
    }
}

TEST(DrawObj, GivesACornerWithoutTextureCoordinateTheOrigin)
{
    recording_gl::reset();
    scene::draw_obj(scene_test::mesh_of(2, false));
    int texture_coordinates = 0;
    for (const Call& call : recording_gl::calls()) {
        if (call.name == "glTexCoord2f") {
            ++texture_coordinates;
            EXPECT_EQ(call.arguments, (std::vector<double>{0.0, 0.0}));
        }
    }
    EXPECT_EQ(texture_coordinates, 6);
}

TEST(DrawShape, LeavesOutWiresAndNothingElse)
{
    mesh::ObjMesh obj;
    const auto add = [&obj](float width, float length) {
        const int first = static_cast<int>(obj.positions.size());
        obj.positions.insert(obj.positions.end(), {{0, 0, 0}, {width, 0, 0}, {0, length, 0}});
        mesh::Face face{};
        for (int corner = 0; corner < 3; ++corner) {
            face.vertices[static_cast<std::size_t>(corner)] = {.position = first + corner, .normal = 0};
        }
        obj.faces.push_back(face);
    };
    add(0.03f, 2.0f); // a whip antenna
    add(0.03f, 0.5f); // as thin, but short
    add(0.3f, 2.0f);
    recording_gl::reset();
    scene::draw_shape(obj);
    std::vector<double> heights;
    for (const Call& call : recording_gl::calls()) {
        if (call.name == "glVertex3f") {
            heights.push_back(call.arguments[1]);
        }
    }
    EXPECT_EQ(heights, (std::vector<double>{0, 0, 0.5, 0, 0, 2}));
}

TEST(DrawObj, OfAnEmptyMeshDrawsNothing)
{
    recording_gl::reset();
    scene::draw_obj({});
    EXPECT_EQ(recording_gl::calls().size(), 2u); // glBegin, glEnd
}

} // namespace
