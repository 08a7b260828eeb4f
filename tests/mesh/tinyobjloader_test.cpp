#include "mesh/obj_reader.h"
#include "tests/mesh/sample_files.h"

#include <gtest/gtest.h>
#include <random>
#include <sstream>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

// tinyobjloader reads the same texts as read_obj: those that both accept must give the same.

namespace {

void expect_same_as_tinyobjloader(const std::string& text)
{
    const base::Result<mesh::ObjMesh> ours = mesh::read_obj("test.obj", text);
    ASSERT_TRUE(ours) << ours.error().message();
    const mesh::ObjMesh& m = ours.value();

    tinyobj::attrib_t theirs;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warnings;
    std::string errors;
    std::istringstream stream(text);
    ASSERT_TRUE(tinyobj::LoadObj(&theirs, &shapes, &materials, &warnings, &errors, &stream, nullptr, false))
        << errors;

    ASSERT_EQ(theirs.vertices.size(), 3 * m.positions.size());
    for (std::size_t i = 0; i < theirs.vertices.size(); ++i) {
        ASSERT_EQ(theirs.vertices[i], m.positions[i / 3][int(i % 3)]);
    }
    ASSERT_EQ(theirs.texcoords.size(), 2 * m.texture_coordinates.size());
    for (std::size_t i = 0; i < theirs.texcoords.size(); ++i) {
        ASSERT_EQ(theirs.texcoords[i], m.texture_coordinates[i / 2][int(i % 2)]);
    }
    ASSERT_LE(theirs.normals.size(), 3 * m.normals.size()); // computed ones follow
    for (std::size_t i = 0; i < theirs.normals.size(); ++i) {
        ASSERT_EQ(theirs.normals[i], m.normals[i / 3][int(i % 3)]);
    }

    std::size_t corner = 0;
    for (const tinyobj::shape_t& shape : shapes) {
        for (const tinyobj::index_t& index : shape.mesh.indices) {
            ASSERT_LT(corner / 3, m.faces.size());
            const mesh::FaceVertex& v = m.faces[corner / 3].vertices[corner % 3];
            ASSERT_EQ(index.vertex_index, v.position);
            ASSERT_EQ(index.texcoord_index, v.texture_coordinate);
            if (index.normal_index >= 0) {
                ASSERT_EQ(index.normal_index, v.normal);
            }
            ++corner;
        }
    }
    ASSERT_EQ(corner, 3 * m.faces.size());
}

/// Writes a random triangle mesh within what tinyobjloader reads too: no continued lines, no comments behind
/// statements.
std::string random_triangles(unsigned seed)
{
    std::mt19937 random(seed);
    std::ostringstream text;
    const auto number = [&]() -> std::ostream& {
        text << ' ' << (random() % 2 == 0 ? "-" : "");
        text << random() % 1000;
        if (random() % 2 == 0) {
            text << '.' << random();
        }
        if (random() % 4 == 0) {
            text << (random() % 2 == 0 ? "e-" : "E+") << random() % 12;
        }
        return text;
    };
    int positions = 0;
    int normals = 0;
    int texture_coordinates = 0;
    const auto index = [&](int count) {
        return random() % 2 == 0 ? 1 + int(random() % unsigned(count)) : -1 - int(random() % unsigned(count));
    };
    for (int round = 0; round < 3; ++round) {
        for (unsigned i = 3 + random() % 5; i > 0; --i, ++positions) {
            text << 'v', number(), number(), number();
            if (random() % 3 == 0) {
                number(), number(), number();
            }
            text << (random() % 2 == 0 ? "\n" : "\r\n");
        }
        for (unsigned i = 1 + random() % 3; i > 0; --i, ++normals) {
            text << "vn", number(), number(), number() << '\n';
        }
        for (unsigned i = 1 + random() % 3; i > 0; --i, ++texture_coordinates) {
            text << "  vt", number(), number(), number() << '\n';
        }
        text << "g part " << round << "\ns " << round << "\nusemtl none\n";
        for (unsigned i = 1 + random() % 6; i > 0; --i) {
            const unsigned form = random() % 4;
            text << "f";
            for (int c = 0; c < 3; ++c) {
                text << (random() % 3 == 0 ? "\t" : " ") << index(positions);
                if (form == 1 || form == 3) {
                    text << '/' << index(texture_coordinates);
                }
                if (form >= 2) {
                    text << (form == 2 ? "//" : "/") << index(normals);
                }
            }
            text << '\n';
        }
    }
    return text.str();
}

TEST(AgainstTinyobjloader, ReadsTheSampleCubesTriangles)
{
    const base::Result<mesh::ObjMesh> cube = mesh::read_obj("cube.obj", sample_obj());
    ASSERT_TRUE(cube);
    expect_same_as_tinyobjloader(written_obj(cube.value()));
}

TEST(AgainstTinyobjloader, ReadsRandomTriangles)
{
    for (unsigned seed = 1; seed <= 500; ++seed) {
        const std::string text = random_triangles(seed);
        expect_same_as_tinyobjloader(text);
        ASSERT_FALSE(testing::Test::HasFailure()) << text;
    }
}

} // namespace
