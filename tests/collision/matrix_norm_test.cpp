#include "collision/matrix_norm.h"

#include "tests/collision/random_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision {
namespace {

/// By brute force: what the matrix makes of a direction, turned towards the longest again and again.
double stretch_by_iteration(const glm::dmat3& matrix, glm::dvec3 direction)
{
    const glm::dmat3 square = glm::transpose(matrix) * matrix;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 next = square * direction;
        if (glm::length(next) == 0.0) {
            return 0.0;
        }
        direction = glm::normalize(next);
    }
    return glm::length(matrix * direction);
}

TEST(MatrixNormTest, IsExactForTurnsByQuartersMirrorsAndScales)
{
    EXPECT_EQ(largest_stretch(glm::mat3(1)), 1.0);
    EXPECT_EQ(largest_stretch({{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}), 1.0);
    EXPECT_EQ(largest_stretch({{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}), 1.0);
    EXPECT_EQ(largest_stretch(glm::mat3(3)), 3.0);
    EXPECT_EQ(largest_stretch({{1, 0, 0}, {0, 0, -5}, {0, 2, 0}}), 5.0);
    EXPECT_EQ(largest_stretch(glm::mat3(0)), 0.0);
    const double tenth = largest_stretch(glm::mat3(0.1f));
    EXPECT_GE(tenth, static_cast<double>(0.1f));
    EXPECT_DOUBLE_EQ(tenth, static_cast<double>(0.1f));
}

TEST(MatrixNormTest, OfAShearIsTheGoldenRatio)
{
    EXPECT_NEAR(largest_stretch({{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}), 0.5 + std::sqrt(1.25), 1e-11);
    EXPECT_NEAR(largest_stretch({{1, 1, 0}, {0, 1, 0}, {0, 0, -1}}), 0.5 + std::sqrt(1.25), 1e-11);
}

TEST(MatrixNormTest, OfRotationsIsOneAndAMillionthAtMost)
{
    Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const glm::mat3 rotation(random.rotation());
        const double stretch = largest_stretch(rotation);
        ASSERT_NEAR(stretch, 1.0, 5e-7) << i;
        ASSERT_GE(stretch, stretch_by_iteration(rotation, random.direction()) * (1 - 1e-15)) << i;
    }
}

TEST(MatrixNormTest, OfAnyMatrixIsItsLargestSingularValue)
{
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 scale = random.scales(1e-3, 1e3);
        const glm::dmat3 stretched(glm::dvec3(scale.x, 0, 0), glm::dvec3(0, scale.y, 0),
                                   glm::dvec3(0, 0, scale.z));
        const glm::dmat3 turned = random.rotation() * stretched;
        const glm::mat3 matrix(turned * random.rotation());
        const double expected = stretch_by_iteration(matrix, random.direction());
        const double stretch = largest_stretch(matrix);
        ASSERT_GE(stretch, expected * (1 - 1e-15)) << i;
        ASSERT_NEAR(stretch, expected, 1e-6 * expected) << i;
    }
}

TEST(MatrixNormTest, NoDirectionIsStretchedMore)
{
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        const double size = random.any_size(1e-6, 1e6);
        const glm::dvec3 a = random.in_box(size);
        const glm::dvec3 b = random.in_box(size);
        const glm::dvec3 c = i % 2 == 0 ? random.in_box(size) : a + b; // every second one flattens
        const glm::mat3 matrix(a, b, c);
        const double stretch = largest_stretch(matrix);
        for (int j = 0; j < 20; ++j) {
            const glm::dvec3 direction = random.direction();
            ASSERT_LE(glm::length(glm::dmat3(matrix) * direction), stretch * (1 + 1e-15)) << i;
        }
    }
}

} // namespace
} // namespace collision
