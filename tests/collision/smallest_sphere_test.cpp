#include "collision/smallest_sphere.h"

#include "tests/collision/random_geometry.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace collision {
namespace {

BoundingSphere around(const std::vector<glm::vec3>& points)
{
    return smallest_sphere(points);
}

constexpr double FLOAT_STEP = 1.2e-7; // the radius is rounded up to a float

double furthest(const std::vector<glm::vec3>& points, const glm::dvec3& centre)
{
    double result = 0;
    for (const glm::vec3& point : points) {
        result = std::max(result, glm::distance(centre, glm::dvec3(point)));
    }
    return result;
}

/// Checks that every point is inside, and that there is no smaller sphere: from a centre moved by d in any
/// direction, some point is at least sqrt(radius^2 + d^2) away. This holds for the smallest sphere only.
void expect_smallest(Random& random, const std::vector<glm::vec3>& points, const BoundingSphere& sphere)
{
    for (const glm::vec3& point : points) {
        ASSERT_TRUE(sphere.contains(point));
        ASSERT_LE(out_of_sphere(sphere.centre, sphere.radius, point), 0.0L);
    }
    ASSERT_EQ(sphere.radius, static_cast<double>(static_cast<float>(sphere.radius)));
    for (const double part : {1.0, 0.1, 0.01}) {
        for (int i = 0; i < 6; ++i) {
            const double moved = part * sphere.radius;
            const double reached = furthest(points, sphere.centre + moved * random.direction());
            ASSERT_GE(reached,
                      std::sqrt(sphere.radius * sphere.radius + moved * moved) - FLOAT_STEP * sphere.radius)
                << part;
        }
    }
}

TEST(SmallestSphereTest, NoneOneAndCoincidentPoints)
{
    EXPECT_TRUE(around({}).is_empty());
    EXPECT_EQ(around({{1, 2, 3}}), (BoundingSphere{{1, 2, 3}, 0}));
    const glm::vec3 anywhere{0.1f, 0.7f, -1e6f};
    EXPECT_EQ(around(std::vector<glm::vec3>(100, anywhere)), (BoundingSphere{anywhere, 0}));
}

TEST(SmallestSphereTest, KnownAnswers)
{
    EXPECT_EQ(around({{-1, 0, 0}, {1, 0, 0}}), (BoundingSphere{{0, 0, 0}, 1}));
    EXPECT_EQ(around({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}}), (BoundingSphere{{2, 0, 0}, 2}));
    EXPECT_EQ(around({{0, 0, 0}, {1, 0, 0}, {10, 0, 0}, {7, 0, 0}}), (BoundingSphere{{5, 0, 0}, 5}));
    // A right angle: half the hypotenuse. An obtuse one: half the longest side, the third point inside.
    EXPECT_EQ(around({{0, 0, 0}, {6, 0, 0}, {0, 8, 0}}), (BoundingSphere{{3, 4, 0}, 5}));
    EXPECT_EQ(around({{-5, 0, 0}, {5, 0, 0}, {0, 1, 0}}), (BoundingSphere{{0, 0, 0}, 5}));

    const BoundingSphere square = around({{1, 1, 5}, {1, -1, 5}, {-1, 1, 5}, {-1, -1, 5}, {0, 0, 5}});
    EXPECT_NEAR(glm::distance(square.centre, {0, 0, 5}), 0, 1e-12);
    EXPECT_NEAR(square.radius, std::sqrt(2.0), 2e-7);

    const BoundingSphere tetrahedron = around({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
    EXPECT_NEAR(glm::length(tetrahedron.centre), 0, 1e-12);
    EXPECT_NEAR(tetrahedron.radius, std::sqrt(3.0), 3e-7);

    const auto third = static_cast<float>(std::sqrt(3.0));
    const BoundingSphere equilateral = around({{-1, 0, 0}, {1, 0, 0}, {0, third, 0}});
    EXPECT_NEAR(glm::distance(equilateral.centre, {0, 1 / std::sqrt(3.0), 0}), 0, 1e-6);
    EXPECT_NEAR(equilateral.radius, 2 / std::sqrt(3.0), 1e-6);
}

TEST(SmallestSphereTest, AFlatTriangleThatIsNearlyALine)
{
    // Obtuse by a hair and acute by a hair.
    Random random(10);
    for (const float height : {1e-7f, 1e-5f, 1e-3f, 0.999f, 1.0f, 1.001f}) {
        const std::vector<glm::vec3> points{{-1, 0, 0}, {1, 0, 0}, {0, height, 0}};
        expect_smallest(random, points, around(points));
    }
}

TEST(SmallestSphereTest, RandomCloudsOfManyKinds)
{
    Random random(11);
    for (int i = 0; i < 4000; ++i) {
        const double half = random.any_size(1e-3, 1e3);
        const glm::dvec3 centre = random.in_box(i % 5 == 0 ? 1e5 : half);
        std::vector<glm::vec3> points = random.points(1 + random.index(i % 10 == 0 ? 300 : 12), centre, half);
        switch (i % 4) {
        case 1: // in a plane
            for (glm::vec3& point : points) {
                point.z = 0.25f;
            }
            break;
        case 2: // on a line
            for (glm::vec3& point : points) {
                point = point.x * glm::vec3(1, 2, -1);
            }
            break;
        case 3: // many of them twice
            for (std::size_t j = points.size(); j-- > 0;) {
                points.push_back(points[random.index(points.size())]);
            }
            break;
        default:
            break;
        }
        expect_smallest(random, points, around(points));
        ASSERT_FALSE(HasFatalFailure()) << i;
    }
}

TEST(SmallestSphereTest, PointsOnOneSphere)
{
    Random random(12);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 centre = random.in_box(10);
        std::vector<glm::vec3> points;
        for (int j = 0; j < 500; ++j) {
            points.emplace_back(centre + 3.0 * random.direction());
        }
        const BoundingSphere sphere = around(points);
        expect_smallest(random, points, sphere);
        ASSERT_NEAR(sphere.radius, 3.0, 0.1) << i;
    }
    // Exactly on one: the whole points at distance 7 and 9 have many of them.
    for (const int radius : {7, 9}) {
        std::vector<glm::vec3> points;
        for (int x = -radius; x <= radius; ++x) {
            for (int y = -radius; y <= radius; ++y) {
                for (int z = -radius; z <= radius; ++z) {
                    if (x * x + y * y + z * z == radius * radius) {
                        points.emplace_back(x, y, z);
                    }
                }
            }
        }
        ASSERT_GT(points.size(), 50u);
        const BoundingSphere sphere = around(points);
        EXPECT_NEAR(glm::length(sphere.centre), 0, 1e-9);
        EXPECT_NEAR(sphere.radius, radius, 1e-6);
    }
}

TEST(SmallestSphereTest, AGridOfCubes)
{
    std::vector<glm::vec3> points;
    for (int i = 0; i < 1000; ++i) {
        points.emplace_back(i % 10, i / 10 % 10, i / 100);
    }
    const BoundingSphere sphere = around(points);
    EXPECT_NEAR(glm::distance(sphere.centre, glm::dvec3(4.5)), 0, 1e-9);
    EXPECT_NEAR(sphere.radius, 4.5 * std::sqrt(3.0), 1e-6);
}

TEST(SmallestSphereTest, NeverLargerThanTheAverageSphere)
{
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const std::vector<glm::vec3> points = random.cloud(30, 10, 5);
        ASSERT_LE(around(points).radius, average_sphere(points).radius * (1 + FLOAT_STEP)) << i;
    }
}

TEST(SmallestSphereTest, TheOrderOfPointsDoesNotMatter)
{
    Random random(14);
    for (int i = 0; i < 500; ++i) {
        std::vector<glm::vec3> points = random.cloud(60, 10, 5);
        const BoundingSphere sphere = around(points);
        std::shuffle(points.begin(), points.end(), random.bits());
        const BoundingSphere other = around(points);
        ASSERT_NEAR(sphere.radius, other.radius, 2 * FLOAT_STEP * sphere.radius) << i;
        // Near the smallest, the radius grows with the square of the centre's error.
        ASSERT_LE(glm::distance(sphere.centre, other.centre), 1e-4 * sphere.radius) << i;
    }
}

TEST(SmallestSphereTest, MovesAlongWithItsPoints)
{
    Random random(15);
    for (int i = 0; i < 500; ++i) {
        // On a grid of 1/16 m, which floats hold up to 1,000 km.
        std::vector<glm::vec3> points = random.points(1 + random.index(20), {}, 300);
        std::vector<glm::vec3> far;
        for (glm::vec3& point : points) {
            point = glm::round(point) / 16.0f;
            far.push_back(point + glm::vec3(1e6f, -1e6f, 5e5f));
        }
        const BoundingSphere near_sphere = around(points);
        const BoundingSphere far_sphere = around(far);
        ASSERT_NEAR(far_sphere.radius, near_sphere.radius, 1e-6) << i;
        ASSERT_LE(glm::distance(far_sphere.centre - glm::dvec3(1e6, -1e6, 5e5), near_sphere.centre), 1e-4)
            << i;
    }
}

TEST(SmallestSphereTest, AHundredThousandPointsOfEveryKind)
{
    Random random(16);
    constexpr std::size_t MANY = 100000;
    std::vector<glm::vec3> cube = random.points(MANY, {}, 1);
    expect_smallest(random, cube, around(cube));
    std::vector<glm::vec3> ball;
    std::vector<glm::vec3> shell;
    std::vector<glm::vec3> line;
    for (std::size_t i = 0; i < MANY; ++i) {
        const double out = random.uniform(0, 1);
        ball.emplace_back(out * random.direction());
        shell.emplace_back(random.direction());
        line.emplace_back(static_cast<float>(i), 0.0f, 0.0f); // the worst order for moving to the front
    }
    for (const std::vector<glm::vec3>* points : {&ball, &shell, &line}) {
        expect_smallest(random, *points, around(*points));
    }
    EXPECT_EQ(around(line), (BoundingSphere{{49999.5, 0, 0}, 49999.5}));
    EXPECT_EQ(around(std::vector<glm::vec3>(MANY, {1, 2, 3})), (BoundingSphere{{1, 2, 3}, 0}));
}

TEST(SmallestSphereTest, SizesFromTheSmallestToTheLargestFloats)
{
    Random random(17);
    for (const double size : {1e-38, 1e-30, 1e-12, 1e12, 1e30, 1e38}) {
        const std::vector<glm::vec3> points = random.points(20, {}, size);
        expect_smallest(random, points, around(points));
    }
}

TEST(SmallestSphereTest, WhatIsNotFiniteComesToAnEnd)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {infinity, -infinity, nan}) {
        around({{bad, 0, 0}, {1, 2, 3}, {0, 5, 0}});
        around({{1, 2, 3}, {bad, bad, bad}, {0, 5, 0}, {7, 0, 0}});
    }
}

} // namespace
} // namespace collision
