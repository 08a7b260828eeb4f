#include "assets/low_paint.h"

#include "asset_fixtures.h"

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace assets {
namespace {

/// Adds a square of two triangles to a mesh: from `corner` along u and v, which lie so that it looks along
/// their cross product. The whole of it has the texture coordinate (s, 0.5).
void add_square(mesh::ObjMesh& obj, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, float s)
{
    const int first = static_cast<int>(obj.positions.size());
    obj.positions.insert(obj.positions.end(), {corner, corner + u, corner + u + v, corner + v});
    obj.normals.push_back(glm::normalize(glm::cross(u, v)));
    obj.texture_coordinates.push_back({s, 0.5f});
    const int normal = static_cast<int>(obj.normals.size()) - 1;
    for (const std::array<int, 3>& corners : {std::array{0, 1, 2}, {0, 2, 3}}) {
        mesh::Face face{};
        for (std::size_t i = 0; i < 3; ++i) {
            face.vertices[i] = {
                .position = first + corners[i], .normal = normal, .texture_coordinate = normal};
        }
        obj.faces.push_back(face);
    }
}

constexpr glm::vec3 X{1, 0, 0};
constexpr glm::vec3 Y{0, 1, 0};
constexpr glm::vec3 Z{0, 0, 1};

/// Four pixels in a row: red, green, blue, and black.
image::Image four_colours()
{
    return {.width = 4, .height = 1, .channels = 3, .pixels = {200, 0, 0, 0, 200, 0, 0, 0, 200, 0, 0, 0}};
}

constexpr float RED = 0.125f;
constexpr float GREEN = 0.375f;
constexpr float BLUE = 0.625f;
constexpr float BLACK = 0.875f;

/// Expects that all corners of a face have a colour.
void expect_colour(const FacePaint& face, const glm::vec3& of_255)
{
    for (const glm::vec3& paint : face) {
        EXPECT_LT(glm::distance(255.0f * paint, of_255), 1.0f)
            << paint.r << ", " << paint.g << ", " << paint.b;
    }
}

TEST(LowPaint, IsWhatTheTextureShowsWhereTheHighMeshLiesAndLooksTheSameWay)
{
    mesh::ObjMesh high;
    add_square(high, {0, 1, 0}, Z, X, RED);   // above, looking up
    add_square(high, {0, 0, 1}, X, Y, GREEN); // in front, looking ahead
    add_square(high, {5, 1, 0}, Z, X, BLUE);  // beside, looking up
    mesh::ObjMesh low;
    add_square(low, {-0.02f, 1.02f, -0.02f}, 1.1f * Z, 1.1f * X, 0.0f);
    add_square(low, {0, 0, 1.05f}, X, Y, 0.0f);
    add_square(low, {4.9f, 0.95f, 0}, Z, 1.2f * X, 0.0f);
    const std::vector<FacePaint> paint = paint_of(low, high, four_colours(), PAINT_VIEW);
    ASSERT_EQ(paint.size(), 6u);
    for (std::size_t triangle : {0u, 1u}) {
        expect_colour(paint[triangle], {200, 0, 0});
        expect_colour(paint[2 + triangle], {0, 200, 0});
        expect_colour(paint[4 + triangle], {0, 0, 200});
    }
}

TEST(LowPaint, IsTheMeanByAreaOfWhatItStandsFor)
{
    mesh::ObjMesh high;
    for (int i = 0; i < 32; ++i) { // red and green in turn, green three times as wide
        const float x = 0.0625f * static_cast<float>(i);
        add_square(high, {x, 0, 0}, Z, 0.015625f * X, RED);
        add_square(high, {x + 0.015625f, 0, 0}, Z, 0.046875f * X, GREEN);
    }
    mesh::ObjMesh low;
    add_square(low, {0, 0, 0}, Z, 2.0f * X, 0.0f);
    for (const FacePaint& face : paint_of(low, high, four_colours(), PAINT_VIEW)) {
        for (const glm::vec3& corner : face) {
            EXPECT_NEAR(255.0f * corner.r, 50.0f, 10.0f);
            EXPECT_NEAR(255.0f * corner.g, 150.0f, 10.0f);
        }
    }
}

TEST(LowPaint, IsWhatTheTextureShowsFromAfar)
{
    constexpr int SIZE = 64; // pixels for a metre, red and green in turn
    image::Image chequered{.width = SIZE, .height = SIZE, .channels = 3, .pixels = {}};
    for (int i = 0; i < SIZE * SIZE; ++i) {
        const bool is_red = (i + i / SIZE) % 2 == 0;
        chequered.pixels.insert(chequered.pixels.end(), {std::uint8_t(is_red ? 200 : 0),
                                                         std::uint8_t(is_red ? 0 : 200), std::uint8_t(0)});
    }
    mesh::ObjMesh high;
    add_square(high, {0, 0, 0}, Z, X, 0.0f);
    high.texture_coordinates = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    for (mesh::Face& face : high.faces) {
        for (mesh::FaceVertex& corner : face.vertices) {
            corner.texture_coordinate = corner.position;
        }
    }
    for (const FacePaint& face : paint_of(high, high, chequered, PAINT_VIEW)) {
        expect_colour(face, {100, 100, 0});
    }
}

TEST(LowPaint, OfACornerIsWhatIsNearIt)
{
    mesh::ObjMesh high;
    add_square(high, {0, 0, 0}, Z, X, RED);
    add_square(high, {1, 0, 0}, Z, X, GREEN);
    mesh::ObjMesh low;
    add_square(low, {0, 0, 0}, Z, 2.0f * X, 0.0f);
    const std::vector<FacePaint> paint = paint_of(low, high, four_colours(), PAINT_VIEW);
    ASSERT_EQ(paint.size(), 2u);
    for (std::size_t face = 0; face < 2; ++face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto at = static_cast<std::size_t>(low.faces[face].vertices[corner].position);
            const bool is_red = low.positions[at].x < 1.0f;
            EXPECT_GT(paint[face][corner][is_red ? 0 : 1], 2.0f * paint[face][corner][is_red ? 1 : 0]);
        }
    }
}

TEST(LowPaint, LeavesOutWhatIsHidden)
{
    mesh::ObjMesh high;
    add_square(high, {0, 0, 0}, Z, X, RED);
    add_square(high, {0, -0.6f, 0}, Z, X, GREEN); // deep inside
    add_square(high, {0, 0.01f, 0}, Z, X, BLACK); // as dark as only shade is
    mesh::ObjMesh low;
    add_square(low, {0, 0, 0}, Z, X, 0.0f);
    const std::vector<FacePaint> paint = paint_of(low, high, four_colours(), PAINT_VIEW);
    expect_colour(paint[0], {200, 0, 0});
}

TEST(LowPaint, OfAFaceThatNothingLooksLikeIsTheWholeMeshs)
{
    mesh::ObjMesh high;
    add_square(high, {0, 0, 0}, Z, X, RED);
    add_square(high, {2, 0, 0}, Z, X, BLUE);
    mesh::ObjMesh low;
    add_square(low, {0, -1, 0}, X, Z, 0.0f); // looks down
    expect_colour(paint_of(low, high, four_colours(), PAINT_VIEW)[0], {100, 0, 100});
    expect_colour(paint_of(low, {}, four_colours(), PAINT_VIEW)[0],
                  {255, 255, 255}); // nothing to take it from
}

TEST(LowPaint, GivesNumbersForFacesWithoutArea)
{
    mesh::ObjMesh flat;
    add_square(flat, {0, 0, 0}, Z, Z, RED);
    for (const FacePaint& paint : paint_of(flat, flat, four_colours(), PAINT_VIEW)) {
        expect_colour(paint, {255, 255, 255});
    }
}

TEST(LowPaint, OfOurTankTellsGunmetalFromPaint)
{
    const Assets& assets = own_assets();
    const auto mean = [&](tank::MeshKind kind) {
        const std::vector<FacePaint>& paint = assets.low_paint[tank::index_of(kind)];
        EXPECT_EQ(paint.size(), assets.low[tank::index_of(kind)].faces.size());
        glm::vec3 sum(0.0f);
        for (const FacePaint& face : paint) {
            sum += (face[0] + face[1] + face[2]) / static_cast<float>(3 * paint.size());
        }
        return sum;
    };
    EXPECT_GT(mean(tank::MeshKind::main_gun).g, 1.2f * mean(tank::MeshKind::secondary_gun).g);
}

} // namespace
} // namespace assets
