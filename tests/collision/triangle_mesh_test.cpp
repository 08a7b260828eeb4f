#include "collision/triangle_mesh.h"

#include "tests/collision/random_geometry.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

namespace collision {
namespace {

using Mesh = std::vector<Triangle>;

/// A closed surface around a place, anticlockwise seen from outside: a cube cut into 2 n^2 triangles a side,
/// blown up towards a ball by `roundness` and bumpy by `bumps`. All triangles share their neighbours'
/// corners to the bit.
Mesh closed_mesh(int n, double half, const glm::dvec3& place, double roundness = 0, double bumps = 0)
{
    const auto corner = [&](const glm::dvec3& on_cube) {
        const glm::dvec3 on_ball = glm::normalize(on_cube);
        const double bump = bumps * std::sin(7 * on_cube.x) * std::cos(5 * on_cube.y - 3 * on_cube.z);
        return glm::vec3(place + half * ((1 - roundness) * on_cube + roundness * on_ball) * (1 + bump));
    };
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto on_cube = [&](int i, int j) {
                glm::dvec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = -1 + 2.0 * i / n;
                p[(axis + 2) % 3] = -1 + 2.0 * j / n;
                return corner(p);
            };
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const glm::vec3 a = on_cube(i, j);
                    const glm::vec3 b = on_cube(i + 1, j);
                    const glm::vec3 c = on_cube(i + 1, j + 1);
                    const glm::vec3 d = on_cube(i, j + 1);
                    if (side > 0) {
                        mesh.push_back({a, b, c});
                        mesh.push_back({a, c, d});
                    } else {
                        mesh.push_back({a, c, b});
                        mesh.push_back({a, d, c});
                    }
                }
            }
        }
    }
    return mesh;
}

glm::dvec3 transformed_point(const glm::dmat4& matrix, const glm::vec3& point)
{
    return glm::dvec3(matrix * glm::dvec4(point, 1));
}

TEST(TriangleMeshTest, TheCubeIsAsKnown)
{
    const Mesh cube = closed_mesh(1, 1, {});
    ASSERT_EQ(cube.size(), 12u);
    EXPECT_NEAR(winding_number({0, 0, 0}, cube), 1, 1e-12);
    EXPECT_NEAR(winding_number({0.999, -0.999, 0.999}, cube), 1, 1e-12);
    EXPECT_NEAR(winding_number({1.001, 0, 0}, cube), 0, 1e-12);
    EXPECT_NEAR(winding_number({100, 200, 300}, cube), 0, 1e-12);
    EXPECT_TRUE(is_point_inside_mesh({0.5, 0.5, -0.5}, cube));
    EXPECT_FALSE(is_point_inside_mesh({0.5, 1.5, -0.5}, cube));

    const auto nearest = nearest_triangle({3, 0.25, 0.5}, cube);
    ASSERT_TRUE(nearest);
    EXPECT_EQ(nearest->distance, 2);
    EXPECT_EQ(nearest->point, glm::dvec3(1, 0.25, 0.5));
    EXPECT_EQ(closest_point_on_triangle({3, 0.25, 0.5}, cube[nearest->triangle]), nearest->point);
}

TEST(TriangleMeshTest, AMeshWithoutTrianglesIsNowhere)
{
    EXPECT_FALSE(nearest_triangle({1, 2, 3}, {}));
    EXPECT_EQ(winding_number({1, 2, 3}, {}), 0);
    EXPECT_FALSE(is_point_inside_mesh({1, 2, 3}, {}));
}

TEST(TriangleMeshTest, WhatIsNotFiniteIsNotInside)
{
    const Mesh cube = closed_mesh(1, 1, {});
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(is_point_inside_mesh({bad, 0, 0}, cube));
        EXPECT_FALSE(nearest_triangle({bad, 0, 0}, cube));
    }
}

TEST(TriangleMeshTest, OnTheSurfaceNothingBreaks)
{
    const Mesh cube = closed_mesh(2, 1, {});
    for (const glm::dvec3& point :
         {glm::dvec3(1, 0.3, 0.2), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 1), glm::dvec3(1, 1, 0.3)}) {
        const double winding = winding_number(point, cube);
        EXPECT_GE(winding, -1e-9);
        EXPECT_LE(winding, 1 + 1e-9);
        EXPECT_EQ(nearest_triangle(point, cube)->distance, 0);
    }
}

TEST(TriangleMeshTest, InsideOutOverlappingAndBrokenMeshesStillHaveAnInside)
{
    Mesh inside_out = closed_mesh(3, 1, {});
    for (Triangle& triangle : inside_out) {
        std::swap(triangle.b, triangle.c);
    }
    EXPECT_NEAR(winding_number({0, 0, 0}, inside_out), -1, 1e-12);
    EXPECT_TRUE(is_point_inside_mesh({0, 0, 0}, inside_out));

    Mesh overlapping = closed_mesh(3, 1, {});
    const Mesh other = closed_mesh(3, 1, {1, 0, 0});
    overlapping.insert(overlapping.end(), other.begin(), other.end());
    EXPECT_NEAR(winding_number({0.5, 0, 0}, overlapping), 2, 1e-12);
    EXPECT_TRUE(is_point_inside_mesh({0.5, 0.3, 0}, overlapping)); // counting crossings would call it outside
    EXPECT_TRUE(is_point_inside_mesh({-0.5, 0, 0}, overlapping));
    EXPECT_FALSE(is_point_inside_mesh({2.5, 0, 0}, overlapping));

    Mesh broken = closed_mesh(6, 1, {}); // every sixteenth triangle turned, some lost
    for (std::size_t i = 0; i < broken.size(); i += 16) {
        std::swap(broken[i].a, broken[i].b);
    }
    broken.resize(broken.size() - 8);
    EXPECT_TRUE(is_point_inside_mesh({0, 0, 0}, broken));
    EXPECT_TRUE(is_point_inside_mesh({0.4, -0.4, 0.4}, broken));
    EXPECT_FALSE(is_point_inside_mesh({1.4, -1.4, 1.4}, broken));
}

TEST(TriangleMeshTest, PointsInsideABallAreInsideItsMeshWhereverItLies)
{
    Random random(70);
    for (int i = 0; i < 60; ++i) {
        const double size = random.any_size(0.5, 5);
        const glm::dvec3 place = random.in_box(i % 3 == 0 ? 1e5 : 10);
        const Mesh ball = closed_mesh(6, size, place, 1);
        for (int j = 0; j < 30; ++j) {
            const double out = random.uniform(0, 2);
            if (out > 0.93 && out < 1.01) {
                continue; // between the ball and its mesh
            }
            const glm::dvec3 point = place + out * size * random.direction();
            ASSERT_EQ(is_point_inside_mesh(point, ball), out < 1) << i;
            ASSERT_NEAR(winding_number(point, ball), out < 1 ? 1 : 0, 1e-9) << i;
            const auto nearest = nearest_triangle(point, ball);
            ASSERT_NEAR(nearest->distance, std::abs(out - 1) * size, 0.06 * size) << i;
        }
    }
}

TEST(TriangleMeshTest, TheWindingNumberAgreesWithCountingCrossings)
{
    Random random(71);
    const Mesh mesh = closed_mesh(8, 1, {}, 0.5, 0.3);
    int inside = 0;
    for (int i = 0; i < 1500; ++i) {
        const glm::dvec3 point = random.in_box(1.4);
        const glm::dvec3 far = point + 10.0 * random.direction(); // meets no edge, but by a rare accident
        int crossings = 0;
        for (const Triangle& triangle : mesh) {
            crossings += intersect_segment_triangle(point, far, triangle) ? 1 : 0;
        }
        ASSERT_EQ(is_point_inside_mesh(point, mesh), crossings % 2 == 1) << i;
        inside += crossings % 2;
    }
    EXPECT_GT(inside, 200);
    EXPECT_LT(inside, 1300);
}

TEST(TriangleMeshTest, EveryTriangleAtACornerIsMetThereWhereNothingIsRounded)
{
    const Mesh cube = closed_mesh(4, 1, {});
    for (const Triangle& aimed_at : cube) {
        const glm::dvec3 corner(aimed_at.a);
        for (const Triangle& triangle : cube) {
            const bool is_at_corner =
                triangle.a == aimed_at.a || triangle.b == aimed_at.a || triangle.c == aimed_at.a;
            ASSERT_EQ(intersect_segment_triangle({0, 0, 0}, 2.0 * corner, triangle).has_value(),
                      is_at_corner);
        }
    }
}

TEST(TriangleMeshTest, NothingLeavesAClosedMeshThroughItsEdgesAndCorners)
{
    Random random(72);
    for (int i = 0; i < 60; ++i) {
        const double place = i % 2 == 0 ? 0 : 1000;
        const glm::dmat4 motion = random.rigid_motion(place);
        Mesh mesh = closed_mesh(4, 1, {}, random.uniform(0, 1));
        for (Triangle& triangle : mesh) {
            for (glm::vec3* corner : {&triangle.a, &triangle.b, &triangle.c}) {
                *corner = glm::vec3(transformed_point(motion, *corner));
            }
        }
        const glm::dvec3 inside = glm::dvec3(motion * glm::dvec4(random.in_box(0.3), 1));
        for (const Triangle& triangle : mesh) {
            const glm::dvec3 a(triangle.a);
            const glm::dvec3 b(triangle.b);
            for (const glm::dvec3& target : {a, 0.5 * (a + b), a + random.uniform(0, 1) * (b - a)}) {
                const glm::dvec3 outside = inside + 3.0 * (target - inside);
                ASSERT_TRUE(std::any_of(mesh.begin(), mesh.end(), [&](const Triangle& other) {
                    return intersect_segment_triangle(inside, outside, other).has_value();
                })) << i;
            }
        }
    }
}

} // namespace
} // namespace collision
