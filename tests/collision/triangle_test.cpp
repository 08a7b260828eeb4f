#include "collision/triangle.h"

#include "collision/closest_point.h"
#include "tests/collision/random_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace collision {
namespace {

const Triangle RIGHT_ANGLE{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleTest, TheClosestPointIsInTheFaceOnAnEdgeOrACorner)
{
    const auto closest = [](double x, double y, double z) {
        return closest_point_on_triangle({x, y, z}, RIGHT_ANGLE);
    };
    EXPECT_EQ(closest(1, 1, 5), glm::dvec3(1, 1, 0));
    EXPECT_EQ(closest(1, 1, -5), glm::dvec3(1, 1, 0));
    EXPECT_EQ(closest(1, 2, 0), glm::dvec3(1, 2, 0)); // on it
    EXPECT_EQ(closest(-1, -2, 3), glm::dvec3(0, 0, 0));
    EXPECT_EQ(closest(9, -1, 0), glm::dvec3(4, 0, 0));
    EXPECT_EQ(closest(-1, 9, 1), glm::dvec3(0, 4, 0));
    EXPECT_EQ(closest(3, -2, 1), glm::dvec3(3, 0, 0));
    EXPECT_EQ(closest(-7, 1, 0), glm::dvec3(0, 1, 0));
    EXPECT_EQ(closest(4, 4, 7), glm::dvec3(2, 2, 0));
    EXPECT_EQ(closest(0, 0, 0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(closest(0, 2, 1), glm::dvec3(0, 2, 0)); // above an edge
}

TEST(TriangleTest, ATriangleWithoutAreaIsALineOrAPoint)
{
    const Triangle line{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(closest_point_on_triangle({3, 5, 0}, line), glm::dvec3(3, 0, 0));
    EXPECT_EQ(closest_point_on_triangle({9, 5, 0}, line), glm::dvec3(4, 0, 0));
    const Triangle twice{{1, 1, 1}, {1, 1, 1}, {3, 1, 1}};
    EXPECT_EQ(closest_point_on_triangle({2, 0, 0}, twice), glm::dvec3(2, 1, 1));
    const Triangle point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    EXPECT_EQ(closest_point_on_triangle({9, 9, 9}, point), glm::dvec3(1, 2, 3));
}

Triangle random_triangle(Random& random, double half)
{
    const std::vector<glm::vec3> corners = random.points(3, {}, half);
    return {corners[0], corners[1], corners[2]};
}

glm::dvec3 at(const Triangle& triangle, double u, double v)
{
    const glm::dvec3 a(triangle.a);
    return a + u * (glm::dvec3(triangle.b) - a) + v * (glm::dvec3(triangle.c) - a);
}

TEST(TriangleTest, NoOtherPointOfTheTriangleIsCloser)
{
    Random random(60);
    for (int i = 0; i < 5000; ++i) {
        Triangle triangle = random_triangle(random, 3);
        if (i % 3 == 0) { // a needle
            triangle.c = triangle.b + 1e-5f * (triangle.c - triangle.b);
        }
        const glm::dvec3 p = random.in_box(i % 2 == 0 ? 5 : 100);
        const glm::dvec3 closest = closest_point_on_triangle(p, triangle);
        const double distance = glm::distance(p, closest);
        for (int j = 0; j < 30; ++j) {
            double u = random.uniform(0, 1);
            double v = random.uniform(0, 1);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            ASSERT_GE(glm::distance(p, at(triangle, u, v)), distance - 1e-9) << i;
        }
        for (const glm::vec3& corner : {triangle.a, triangle.b, triangle.c}) {
            ASSERT_GE(glm::distance(p, glm::dvec3(corner)), distance - 1e-12) << i;
        }
        // It is a point of the triangle itself, since the closest point to it is no other.
        ASSERT_LE(glm::distance(closest_point_on_triangle(closest, triangle), closest), 1e-9) << i;
    }
}

TEST(TriangleTest, ASegmentMeetsTheFaceFromEitherSide)
{
    for (const double side : {1.0, -1.0}) {
        const auto hit = intersect_segment_triangle({1, 1, 3 * side}, {1, 1, -1 * side}, RIGHT_ANGLE);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->point, glm::dvec3(1, 1, 0));
        EXPECT_EQ(hit->parameter, 0.75);
    }
    const auto slanted = intersect_segment_triangle({0, 0, 1}, {2, 2, -1}, RIGHT_ANGLE);
    ASSERT_TRUE(slanted);
    EXPECT_EQ(slanted->point, glm::dvec3(1, 1, 0));
}

TEST(TriangleTest, EdgesCornersAndTheSegmentsEndsCount)
{
    for (const glm::dvec3& point : {glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 4, 0),
                                    glm::dvec3(2, 0, 0), glm::dvec3(0, 3, 0), glm::dvec3(2, 2, 0)}) {
        const glm::dvec3 up(0, 0, 2);
        const Triangle turned{RIGHT_ANGLE.a, RIGHT_ANGLE.c, RIGHT_ANGLE.b};
        for (const Triangle& triangle : {RIGHT_ANGLE, turned}) {
            EXPECT_TRUE(intersect_segment_triangle(point + up, point - up, triangle));
            EXPECT_TRUE(intersect_segment_triangle(point + up, point, triangle));
            EXPECT_TRUE(intersect_segment_triangle(point, point + up, triangle));
        }
    }
}

TEST(TriangleTest, ASegmentMissesBesideBeforeAndBehind)
{
    EXPECT_FALSE(intersect_segment_triangle({-0.001, 1, 3}, {-0.001, 1, -3}, RIGHT_ANGLE));
    EXPECT_FALSE(intersect_segment_triangle({2.001, 2, 3}, {2.001, 2, -3}, RIGHT_ANGLE));
    EXPECT_FALSE(intersect_segment_triangle({1, 1, 3}, {1, 1, 0.001}, RIGHT_ANGLE));
    EXPECT_FALSE(intersect_segment_triangle({1, 1, -3}, {1, 1, -0.001}, RIGHT_ANGLE));
}

TEST(TriangleTest, NothingIsMetInThePlaneWithoutLengthOrWithoutArea)
{
    EXPECT_FALSE(intersect_segment_triangle({-1, 1, 0}, {5, 1, 0}, RIGHT_ANGLE));
    EXPECT_FALSE(intersect_segment_triangle({1, 1, 0}, {1, 1, 0}, RIGHT_ANGLE));
    const Triangle line{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};
    EXPECT_FALSE(intersect_segment_triangle({1, 0, 1}, {1, 0, -1}, line));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(intersect_segment_triangle({nan, 1, 1}, {1, 1, -1}, RIGHT_ANGLE));
    EXPECT_FALSE(intersect_segment_triangle({1, 1, 1}, {1, 1, nan}, RIGHT_ANGLE));
}

TEST(TriangleTest, ASegmentThroughAPointOfTheTriangleMeetsItThere)
{
    Random random(61);
    for (int i = 0; i < 20000; ++i) {
        const double place = i % 2 == 0 ? 0 : 1e6;
        Triangle triangle = random_triangle(random, 3);
        for (glm::vec3* corner : {&triangle.a, &triangle.b, &triangle.c}) {
            *corner = glm::vec3(glm::dvec3(*corner) + place);
        }
        const glm::dvec3 edge_1 = glm::dvec3(triangle.b) - glm::dvec3(triangle.a);
        const glm::dvec3 edge_2 = glm::dvec3(triangle.c) - glm::dvec3(triangle.a);
        glm::dvec3 direction = random.direction();
        direction *= random.any_size(0.1, 1000);
        const glm::dvec3 normal = glm::cross(edge_1, edge_2);
        if (glm::length(normal) < 0.5 ||
            std::abs(glm::dot(normal, direction)) < 0.1 * glm::length(normal) * glm::length(direction)) {
            continue; // too thin or too grazing to say where it must be met
        }
        const double u = random.uniform(-0.5, 1.5);
        const double v = random.uniform(-0.5, 1.5);
        const double t = random.uniform(-0.5, 1.5);
        const double margin = std::min({u, v, 1 - u - v, t, 1 - t});
        if (std::abs(margin) < 1e-6) {
            continue;
        }
        const glm::dvec3 target = at(triangle, u, v);
        const auto hit =
            intersect_segment_triangle(target - t * direction, target + (1 - t) * direction, triangle);
        ASSERT_EQ(hit.has_value(), margin > 0) << i;
        if (hit) {
            ASSERT_NEAR(hit->parameter, t, 1e-7) << i;
            ASSERT_LE(glm::distance(hit->point, target), 1e-6) << i;
        }
    }
}

} // namespace
} // namespace collision
