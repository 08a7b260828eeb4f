#include "collision/smallest_sphere.h"

#include "tests/collision/random_geometry.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace collision {
namespace {

BoundingSphere around(const std::vector<BoundingSphere>& spheres)
{
    return smallest_enclosing(spheres);
}

double reach(const std::vector<BoundingSphere>& spheres, const glm::dvec3& centre)
{
    double result = 0;
    for (const BoundingSphere& sphere : spheres) {
        if (!sphere.is_empty()) {
            result = std::max(result, glm::distance(centre, sphere.centre) + sphere.radius);
        }
    }
    return result;
}

/// Checks that every sphere is inside, exactly, and that no other centre nearby needs less: how far the
/// spheres reach is a convex function of the centre, so that what is smallest nearby is smallest.
void expect_smallest(Random& random, const std::vector<BoundingSphere>& spheres, const BoundingSphere& root)
{
    for (const BoundingSphere& sphere : spheres) {
        if (!sphere.is_empty()) {
            ASSERT_LE(out_of_sphere(root.centre, root.radius, sphere.centre) +
                          static_cast<Exact>(sphere.radius),
                      0.0L);
        }
    }
    for (const double part : {0.3, 0.03, 3e-3, 3e-4, 3e-6}) {
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 moved = root.centre + part * root.radius * random.direction();
            const double rounding = 1e-15 * glm::length(root.centre); // of the centre
            ASSERT_GE(reach(spheres, moved), root.radius * (1 - 1e-9) - rounding) << part;
        }
    }
}

TEST(SmallestEnclosingTest, NoneAndEmptyOnes)
{
    EXPECT_TRUE(around({}).is_empty());
    EXPECT_TRUE(around({{}, {}}).is_empty());
    EXPECT_EQ(around({{}, {{1, 2, 3}, 4}, {}}), (BoundingSphere{{1, 2, 3}, 4}));
}

TEST(SmallestEnclosingTest, TheOneThatContainsAllOthersIsTheAnswerToTheBit)
{
    const BoundingSphere large{{0.1, 0.2, 0.3}, 5.7};
    EXPECT_EQ(around({large}), large);
    EXPECT_EQ(around({{{1, 0, 0}, 2}, large, {{0, -1, 0}, 3}, {{0.1, 0.2, 0.3}, 5.7}}), large);
    EXPECT_EQ(around({{{0, 0, 0}, 4}, {{1, 0, 0}, 3}}),
              (BoundingSphere{{0, 0, 0}, 4})); // touches from inside
    EXPECT_EQ(around({{{1, 1, 1}, 0}, {{1, 1, 1}, 0}}), (BoundingSphere{{1, 1, 1}, 0}));
}

TEST(SmallestEnclosingTest, KnownAnswers)
{
    EXPECT_EQ(around({{{-2, 0, 0}, 1}, {{2, 0, 0}, 1}}), (BoundingSphere{{0, 0, 0}, 3}));
    const BoundingSphere two = around({{{0, 0, 0}, 1}, {{5, 0, 0}, 2}});
    EXPECT_NEAR(glm::distance(two.centre, {3, 0, 0}), 0, 1e-14);
    EXPECT_NEAR(two.radius, 4, 1e-14);
    // Three of one size are the sphere of their centres, grown.
    const BoundingSphere three = around({{{0, 0, 0}, 0.5}, {{6, 0, 0}, 0.5}, {{0, 8, 0}, 0.5}});
    EXPECT_NEAR(glm::distance(three.centre, {3, 4, 0}), 0, 1e-12);
    EXPECT_NEAR(three.radius, 5.5, 1e-12);
    // Apollonius: three unit circles that touch each other.
    const double h = std::sqrt(3.0);
    const BoundingSphere kiss = around({{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, h, 0}, 1}});
    EXPECT_NEAR(kiss.radius, 1 + 2 / h, 1e-12);
    // Four on a tetrahedron, of which one is larger by 1 and moved inwards by 1 along its corner's direction.
    const glm::dvec3 corner = glm::normalize(glm::dvec3(1, 1, 1));
    const BoundingSphere four =
        around({{{3, -3, -3}, 1}, {{-3, 3, -3}, 1}, {{-3, -3, 3}, 1}, {glm::dvec3(3, 3, 3) - corner, 2}});
    EXPECT_NEAR(glm::length(four.centre), 0, 1e-12);
    EXPECT_NEAR(four.radius, std::sqrt(27.0) + 1, 1e-12);
}

TEST(SmallestEnclosingTest, TheExampleOnWhichMovingToTheFrontFails)
{
    // In the manner of Fischer and Gaertner (2003), figure 2: small spheres beside a large one, almost
    // touching from inside.
    Random random(20);
    for (int i = 0; i < 2000; ++i) {
        std::vector<BoundingSphere> spheres{{{0, 0, 0}, 10}};
        for (int j = 0; j < 5; ++j) {
            const double radius = random.uniform(0.1, 9);
            const double out = random.uniform(-0.01, 0.5);
            spheres.push_back({(10 - radius + out) * random.direction(), radius});
        }
        std::shuffle(spheres.begin(), spheres.end(), random.bits());
        expect_smallest(random, spheres, around(spheres));
        ASSERT_FALSE(HasFatalFailure()) << i;
    }
}

TEST(SmallestEnclosingTest, RandomSpheresOfManyKinds)
{
    Random random(21);
    for (int i = 0; i < 5000; ++i) {
        const double half = random.any_size(1e-2, 1e3);
        const double far = i % 3 == 0 ? 1e6 : half;
        const glm::dvec3 place = random.in_box(far);
        std::vector<BoundingSphere> spheres;
        for (std::size_t j = random.index(20) + 1; j-- > 0;) {
            const double radius = i % 4 == 0 ? random.any_size(1e-6, 1e2) * half : random.uniform(0, half);
            spheres.push_back({place + random.in_box(half), radius});
            if (i % 5 == 1) {
                spheres.back().centre.y = place.y; // in a plane
            }
            if (i % 5 == 2) {
                spheres.back().centre = place + glm::dvec3(random.uniform(-half, half)); // on a line
            }
            if (i % 5 == 3) {
                spheres.back().radius = 0.5 * half; // of one size
                spheres.push_back(spheres.back());
            }
            if (random.index(10) == 0) {
                spheres.push_back({});
            }
        }
        const BoundingSphere root = around(spheres);
        expect_smallest(random, spheres, root);
        ASSERT_FALSE(HasFatalFailure()) << i;
        std::shuffle(spheres.begin(), spheres.end(), random.bits());
        ASSERT_NEAR(around(spheres).radius, root.radius, 1e-9 * root.radius + 1e-15 * far) << i;
    }
}

TEST(SmallestEnclosingTest, SpheresWithoutRadiusAreAsPoints)
{
    Random random(22);
    for (int i = 0; i < 1000; ++i) {
        const std::vector<glm::vec3> points = random.cloud(40, 5, 3);
        std::vector<BoundingSphere> spheres;
        for (const glm::vec3& point : points) {
            spheres.push_back({point, 0});
        }
        ASSERT_NEAR(around(spheres).radius, smallest_sphere(points).radius, 2e-7 * around(spheres).radius)
            << i;
    }
}

TEST(SmallestEnclosingTest, WhatIsInsideAPartIsInsideTheRoot)
{
    Random random(23);
    for (int i = 0; i < 3000; ++i) {
        std::vector<BoundingSphere> spheres;
        const glm::dvec3 place = random.in_box(1e6);
        for (int j = 0; j < 6; ++j) {
            spheres.push_back({place + random.in_box(0.02), 0.01});
        }
        const BoundingSphere root = around(spheres);
        for (const BoundingSphere& sphere : spheres) {
            const glm::dvec3 point = sphere.centre + sphere.radius * random.direction();
            if (out_of_sphere(sphere.centre, sphere.radius, point) <= 0) {
                ASSERT_LE(out_of_sphere(root.centre, root.radius, point), 0) << i;
            }
        }
    }
}

TEST(SmallestEnclosingTest, WhatIsNotFiniteComesToAnEnd)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {infinity, nan}) {
        around({{{bad, 0, 0}, 1}, {{1, 2, 3}, 1}, {{4, 2, 3}, 1}});
        around({{{1, 2, 3}, 1}, {{1, 2, 9}, bad}, {{4, 2, 3}, 1}});
    }
}

} // namespace
} // namespace collision
