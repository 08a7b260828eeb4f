#include "collision/bounding_sphere.h"

#include "collision/rounding.h"
#include "tests/collision/random_geometry.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace collision {
namespace {

BoundingSphere around(const std::vector<glm::vec3>& points)
{
    return average_sphere(points);
}

TEST(BoundingSphereTest, EmptyMeshHasTheEmptySphereThatContainsNothing)
{
    const BoundingSphere sphere = around({});
    EXPECT_TRUE(sphere.is_empty());
    EXPECT_FALSE(sphere.contains(sphere.centre));
    EXPECT_FALSE(sphere.contains({0.1, 0.0, 0.0}));
    EXPECT_EQ(sphere, BoundingSphere{});
}

TEST(BoundingSphereTest, OneVertexHasASphereWithoutRadiusThatContainsIt)
{
    const BoundingSphere sphere = around({{0.1f, -2.3f, 1e6f}});
    EXPECT_EQ(sphere.radius, 0.0);
    EXPECT_FALSE(sphere.is_empty());
    EXPECT_TRUE(sphere.contains(glm::vec3(0.1f, -2.3f, 1e6f)));
    EXPECT_FALSE(sphere.contains({0.1, -2.3, 1e6})); // 0.1 is not 0.1f
}

TEST(BoundingSphereTest, CoincidentVerticesHaveASphereWithoutRadius)
{
    const BoundingSphere sphere = around(std::vector<glm::vec3>(1001, {0.1f, 0.7f, -0.3f}));
    EXPECT_EQ(sphere.radius, 0.0);
    EXPECT_EQ(sphere.centre, glm::dvec3(glm::vec3(0.1f, 0.7f, -0.3f)));
}

TEST(BoundingSphereTest, CentreIsTheAverageVertexAndNotTheMiddle)
{
    const BoundingSphere sphere = around({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}});
    EXPECT_EQ(sphere.centre, glm::dvec3(1, 0, 0));
    EXPECT_EQ(sphere.radius, 3.0);
}

TEST(BoundingSphereTest, RadiusIsTheLargestDistanceToAVertex)
{
    const BoundingSphere sphere = around({{2, 3, 6}, {-2, -3, -6}, {1, 0, 0}, {-1, 0, 0}});
    EXPECT_EQ(sphere.centre, glm::dvec3(0));
    EXPECT_EQ(sphere.radius, 7.0);
}

TEST(BoundingSphereTest, APointExactlyOnTheSphereIsInsideAndTheNextOneIsNot)
{
    const BoundingSphere sphere{{1, 2, 3}, 7.0};
    EXPECT_TRUE(sphere.contains({1 + 2, 2 + 3, 3 + 6}));
    EXPECT_TRUE(sphere.contains({8, 2, 3}));
    EXPECT_FALSE(sphere.contains({8 + 1e-14, 2, 3}));
    EXPECT_FALSE(sphere.contains({std::numeric_limits<double>::quiet_NaN(), 2, 3}));
    EXPECT_FALSE(sphere.contains({std::numeric_limits<double>::infinity(), 2, 3}));
}

TEST(BoundingSphereTest, EveryVertexOfRandomMeshesIsInside)
{
    Random random(2);
    for (int i = 0; i < 3000; ++i) {
        const double half = random.any_size(1e-3, 1e3);
        const glm::dvec3 centre = random.in_box(i % 3 == 0 ? 1e6 : half);
        const std::vector<glm::vec3> points = random.points(1 + random.index(40), centre, half);
        const BoundingSphere sphere = around(points);
        glm::dvec3 sum(0);
        double largest = 0;
        for (const glm::vec3& point : points) {
            ASSERT_TRUE(sphere.contains(point)) << i;
            ASSERT_LE(out_of_sphere(sphere.centre, sphere.radius, point), 0.0L) << i;
            sum += glm::dvec3(point);
            largest = std::max(largest, glm::distance(sphere.centre, glm::dvec3(point)));
        }
        const glm::dvec3 average = sum / static_cast<double>(points.size());
        ASSERT_LE(glm::distance(sphere.centre, average), 1e-9) << i;
        ASSERT_EQ(sphere.radius, static_cast<double>(static_cast<float>(sphere.radius)));
        ASSERT_LE(sphere.radius, largest * (1.0 + 1.2e-7) + 1e-30) << i;
    }
}

TEST(BoundingSphereTest, TheSphereOfPlacedPartsIsThatOfAllTheirVertices)
{
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        std::vector<std::vector<glm::vec3>> meshes;
        std::vector<PlacedPoints> parts;
        glm::dvec3 sum(0);
        double count = 0;
        for (int part = 0; part < 5; ++part) {
            const std::size_t vertices = random.index(6); // some without any
            meshes.push_back(random.points(vertices, random.in_box(3), 2));
        }
        for (const std::vector<glm::vec3>& mesh : meshes) {
            parts.push_back({mesh, glm::mat4(random.rigid_motion(20))});
            for (const glm::vec3& point : mesh) {
                sum += glm::dvec3(glm::dmat4(parts.back().matrix) * glm::dvec4(point, 1));
                count += 1;
            }
        }
        const BoundingSphere sphere = average_sphere(parts);
        ASSERT_EQ(sphere.is_empty(), count == 0);
        if (count == 0) {
            continue;
        }
        ASSERT_LE(glm::distance(sphere.centre, sum / count), 1e-12);
        double largest = 0;
        for (const PlacedPoints& part : parts) {
            for (const glm::vec3& point : part.points) {
                const glm::dvec3 placed(glm::dmat4(part.matrix) * glm::dvec4(point, 1));
                ASSERT_TRUE(sphere.contains(placed));
                largest = std::max(largest, glm::distance(sphere.centre, placed));
            }
        }
        ASSERT_NEAR(sphere.radius, largest, 1.2e-7 * largest);
    }
    EXPECT_TRUE(average_sphere(std::span<const PlacedPoints>{}).is_empty());
}

} // namespace
} // namespace collision
