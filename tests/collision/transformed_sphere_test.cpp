#include "collision/transformed_sphere.h"

#include "tests/collision/random_geometry.h"

#include <gtest/gtest.h>

namespace collision {
namespace {

glm::mat4 moved(const glm::mat3& matrix, const glm::vec3& offset)
{
    glm::mat4 result(matrix);
    result[3] = glm::vec4(offset, 1.0f);
    return result;
}

const glm::mat3 QUARTER_TURN{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}; // about +Y: z becomes x

TEST(TransformedSphereTest, IsExactWhereNothingIsRounded)
{
    const BoundingSphere sphere{{1, 2, 3}, 0.75};
    EXPECT_EQ(transformed(sphere, glm::mat4(1)), sphere);
    EXPECT_EQ(transformed(sphere, moved(glm::mat3(1), {10, 0.5f, -3})), (BoundingSphere{{11, 2.5, 0}, 0.75}));
    EXPECT_EQ(transformed(sphere, moved(QUARTER_TURN, {1, 0, 0})), (BoundingSphere{{4, 2, -1}, 0.75}));
    EXPECT_EQ(transformed(sphere, moved(glm::mat3(2), {})), (BoundingSphere{{2, 4, 6}, 1.5}));
    EXPECT_EQ(transformed(sphere, moved(glm::mat3(-1), {})), (BoundingSphere{{-1, -2, -3}, 0.75}));
    EXPECT_EQ(transformed(sphere, moved(glm::mat3(0), {5, 6, 7})), (BoundingSphere{{5, 6, 7}, 0}));
}

TEST(TransformedSphereTest, FollowsTheLargestScale)
{
    const glm::mat3 scale{{1, 0, 0}, {0, 3, 0}, {0, 0, 2}};
    EXPECT_EQ(transformed({{1, 1, 1}, 2}, glm::mat4(scale)), (BoundingSphere{{1, 3, 2}, 6}));
}

TEST(TransformedSphereTest, ARotationGrowsTheRadiusByAMillionthAtMost)
{
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const BoundingSphere sphere{random.in_box(10), random.any_size(1e-2, 1e2)};
        const BoundingSphere result = transformed(sphere, glm::mat4(random.rigid_motion(100)));
        ASSERT_NEAR(result.radius, sphere.radius, 1e-6 * sphere.radius) << i;
    }
}

TEST(TransformedSphereTest, TheEmptySphereStaysEmpty)
{
    EXPECT_TRUE(transformed({}, moved(glm::mat3(5), {1, 2, 3})).is_empty());
}

/// Holds each of the points on the sphere and a few inside against the transformed sphere, exactly.
void expect_conservative(Random& random, const BoundingSphere& sphere, const glm::mat4& matrix)
{
    const BoundingSphere result = transformed(sphere, matrix);
    for (int i = 0; i < 12; ++i) {
        const double fraction = i % 4 == 0 ? random.uniform(0, 1) : 1.0 - 1e-15;
        const glm::dvec3 point = sphere.centre + fraction * sphere.radius * random.direction();
        if (out_of_sphere(sphere.centre, sphere.radius, point) > 0) {
            continue; // rounded out of it
        }
        ASSERT_LE(out_of_sphere(result.centre, result.radius, matrix, point), 0.0L);
    }
}

TEST(TransformedSphereTest, ContainsWhatItContainedAfterAnyAffineMatrix)
{
    Random random(8);
    for (int i = 0; i < 5000; ++i) {
        const BoundingSphere sphere{glm::dvec3(glm::vec3(random.in_box(5))), random.any_size(1e-2, 10)};
        glm::dmat3 matrix = random.rotation();
        if (i % 3 == 1) { // a scale along some other axes
            const glm::dvec3 s = random.scales(0.1, 10);
            matrix = matrix * glm::dmat3({s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}) * random.rotation();
        } else if (i % 3 == 2) { // a shear, and everything else
            const glm::dvec3 a = random.in_box(2);
            const glm::dvec3 b = random.in_box(2);
            matrix = {a, b, random.in_box(2)};
        }
        const glm::dvec3 offset = random.in_box(i % 2 == 0 ? 10 : 1e6);
        expect_conservative(random, sphere, moved(glm::mat3(matrix), glm::vec3(offset)));
        ASSERT_FALSE(HasFatalFailure()) << i;
    }
}

TEST(TransformedSphereTest, ACentimetreAMillionMetresAwayStaysACentimetreAtItsPlace)
{
    const BoundingSphere sphere{{0.25, 0.003, 0}, 0.01};
    const BoundingSphere result = transformed(sphere, moved(QUARTER_TURN, {1e6f, 1e6f, -1e6f}));
    EXPECT_NEAR(result.centre.x, 1e6, 1e-9);
    EXPECT_NEAR(result.centre.y, 1e6 + 0.003, 1e-9);
    EXPECT_NEAR(result.centre.z, -1e6 - 0.25, 1e-9);
    EXPECT_NEAR(result.radius, 0.01, 1e-9);
    EXPECT_GE(result.radius, 0.01);
}

TEST(TransformedSphereTest, TransformingTwiceContainsTransformingOnce)
{
    Random random(9);
    for (int i = 0; i < 1000; ++i) {
        const BoundingSphere sphere{random.in_box(5), random.any_size(1e-2, 10)};
        const glm::mat4 first(random.rigid_motion(10));
        const glm::mat4 second(random.rigid_motion(1e6));
        const BoundingSphere result = transformed(transformed(sphere, first), second);
        const glm::dvec3 point = sphere.centre + 0.999999 * sphere.radius * random.direction();
        const glm::dvec3 once(glm::dmat4(second) * (glm::dmat4(first) * glm::dvec4(point, 1)));
        ASSERT_TRUE(result.contains(once)) << i;
    }
}

} // namespace
} // namespace collision
