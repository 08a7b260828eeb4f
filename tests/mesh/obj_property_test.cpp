#include "mesh/obj_reader.h"
#include "tests/mesh/invariants.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

// Meshes are made at random and written in as many styles as the format allows; reading must give them back.

namespace {

using mesh::FaceVertex;
using mesh::ObjMesh;

class Writer
{
public:
    explicit Writer(unsigned seed) : random_(seed) { text_.precision(9); }

    int below(int n) { return int(random_() % unsigned(n)); }
    float number()
    {
        const double mantissa = double(random_()) / 4294967296.0 - 0.5;
        return float(mantissa * std::pow(10.0, below(9) - 4));
    }

    /// What may stand between two words.
    void gap()
    {
        static constexpr const char* gaps[] = {" ", "  ", "\t", " \t ", " \\\n", "\\\r\n ", " "};
        text_ << gaps[below(7)];
    }

    /// What may stand at the end of a statement.
    void end()
    {
        static constexpr const char* ends[] = {
            "\n", "\r\n", "\r", " \n", " # comment\n", "\n\n# \\\n", "\ng some group\n"};
        text_ << ends[below(7)];
    }

    template <class Vector> void numbers(const char* keyword, const Vector& values)
    {
        text_ << keyword;
        for (int i = 0; i < Vector::length(); ++i) {
            gap();
            text_ << (below(4) == 0 ? std::scientific : std::defaultfloat) << values[i];
        }
        end();
    }

    void index(int zero_based, std::size_t count)
    {
        if (below(3) == 0) {
            text_ << zero_based - int(count);
        } else {
            text_ << zero_based + 1;
        }
    }

    /// Writes some vertices, then some faces, then more of both, so that negative indices count from many
    /// places.
    ObjMesh write_mesh()
    {
        ObjMesh m;
        const int rounds = 1 + below(4);
        for (int round = 0; round < rounds; ++round) {
            for (int i = 3 + below(6); i > 0; --i) {
                numbers("v", m.positions.emplace_back(number(), number(), number()));
            }
            for (int i = 1 + below(4); i > 0; --i) {
                numbers("vn", m.normals.emplace_back(number(), number(), 1));
            }
            for (int i = 1 + below(4); i > 0; --i) {
                numbers("vt", m.texture_coordinates.emplace_back(number(), number()));
            }
            for (int i = 1 + below(5); i > 0; --i) {
                write_face(m);
            }
        }
        return m;
    }

    std::string text() const { return text_.str(); }

private:
    void write_face(ObjMesh& m)
    {
        const bool textured = below(2) == 0;
        mesh::Face face;
        text_ << "f";
        for (FaceVertex& v : face.vertices) {
            v.position = below(int(m.positions.size()));
            v.normal = below(int(m.normals.size()));
            v.texture_coordinate = textured ? below(int(m.texture_coordinates.size())) : -1;
            gap();
            index(v.position, m.positions.size());
            text_ << '/';
            if (textured) {
                index(v.texture_coordinate, m.texture_coordinates.size());
            }
            text_ << '/';
            index(v.normal, m.normals.size());
        }
        end();
        m.faces.push_back(face);
    }

    std::mt19937 random_;
    std::ostringstream text_;
};

TEST(ReadObjProperty, GivesBackAnyMeshInAnyStyleOfWriting)
{
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        Writer writer(seed);
        const ObjMesh written = writer.write_mesh();
        const base::Result<ObjMesh> read = mesh::read_obj("random.obj", writer.text());
        ASSERT_TRUE(read) << read.error().message() << " in\n" << writer.text();
        EXPECT_EQ(read.value().positions, written.positions);
        EXPECT_EQ(read.value().normals, written.normals);
        EXPECT_EQ(read.value().texture_coordinates, written.texture_coordinates);
        EXPECT_EQ(read.value().faces, written.faces);
        ASSERT_FALSE(testing::Test::HasFailure()) << writer.text();
    }
}

TEST(ReadObjProperty, KeepsItsPromisesForAnyPolygonsWithoutNormals)
{
    std::mt19937 random(7);
    for (int i = 0; i < 1000; ++i) {
        const unsigned vertices = 3 + random() % 12;
        std::string text;
        for (unsigned v = 0; v < vertices; ++v) {
            text += "v " + std::to_string(random() % 5) + ' ' + std::to_string(random() % 5) + ' ' +
                    std::to_string(random() % 3) + '\n';
        }
        std::size_t triangles = 0;
        for (int face = 0; face < 5; ++face) {
            text += "s " + std::to_string(random() % 3) + "\nf";
            const unsigned corners = 3 + random() % 8;
            for (unsigned c = 0; c < corners; ++c) {
                text += ' ' + std::to_string(1 + random() % vertices);
            }
            text += '\n';
            triangles += corners - 2;
        }
        const base::Result<ObjMesh> read = mesh::read_obj("random.obj", text);
        ASSERT_TRUE(read) << read.error().message();
        ASSERT_EQ(broken_invariant(read.value()), "") << text;
        ASSERT_EQ(read.value().faces.size(), triangles);
        for (const glm::vec3& normal : read.value().normals) {
            ASSERT_NEAR(glm::dot(normal, normal), 1, 1e-5);
        }
    }
}

} // namespace
