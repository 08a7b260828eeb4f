#include "collision/rounding.h"

#include "tests/collision/random_geometry.h"

#include <gtest/gtest.h>

namespace collision {
namespace {

TEST(RoundingTest, NothingIsGainedWhereNothingIsLost)
{
    EXPECT_EQ(sum_up(1.0, 2.0), 3.0);
    EXPECT_EQ(product_up(3.0, -7.0), -21.0);
    EXPECT_EQ(sqrt_up(9.0), 3.0);
    EXPECT_EQ(sqrt_up(0.0), 0.0);
    EXPECT_EQ(distance_up({1, 2, 3}, {1 + 2, 2 - 3, 3 + 6}), 7.0);
    EXPECT_EQ(distance_up({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}), 0.0);
    EXPECT_EQ(float_up(0.5), 0.5f);
    EXPECT_EQ(float_up(0.1), 0.1f); // 0.1f is above 0.1
}

TEST(RoundingTest, WhatIsLostIsRoundedUp)
{
    EXPECT_EQ(sum_up(1.0, 1e-30), next_up(1.0));
    EXPECT_EQ(sum_up(1.0, -1e-30), 1.0);
    EXPECT_EQ(product_up(1.0 + 0x1p-52, 1.0 + 0x1p-52), next_up(1.0 + 0x1p-51));
    EXPECT_GT(float_up(1.0 + 1e-12), 1.0f);
    EXPECT_GE(static_cast<double>(float_up(0.3)), 0.3);
    EXPECT_EQ(float_up(1e300), std::numeric_limits<float>::infinity());
}

TEST(RoundingTest, ResultsAreNeverBelowAndAtMostOneStepAboveTheExactOnes)
{
    Random random(1);
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 numbers = random.in_box(random.any_size(1e-6, 1e6));
        const double a = numbers.x;
        const double b = numbers.y * random.any_size(1e-6, 1e6);
        const WithError sum = two_sum(a, b);
        const WithError product = two_product(a, b);
        // The errors are exact, so adding them back changes nothing.
        ASSERT_EQ(sum.value + sum.error, sum.value);
        ASSERT_EQ(product.value + product.error, product.value);
        ASSERT_GE(static_cast<Exact>(sum_up(a, b)), static_cast<Exact>(a) + static_cast<Exact>(b));
        ASSERT_GE(sum_up(a, b), a + b);
        ASSERT_LE(sum_up(a, b), next_up(a + b));
        ASSERT_GE(product_up(a, b), a * b);
        ASSERT_LE(product_up(a, b), next_up(a * b));
        const double root = sqrt_up(std::abs(a));
        const WithError square = two_product(root, root);
        ASSERT_TRUE(square.value > std::abs(a) || (square.value == std::abs(a) && square.error >= 0.0));
        ASSERT_LE(root, next_up(std::sqrt(std::abs(a))));
        const glm::dvec3 p(a, b, 1.0);
        const glm::dvec3 q(b, 0.3, a);
        ASSERT_LE(out_of_sphere(p, distance_up(p, q), q), 0.0L);
        ASSERT_GE(distance_up(p, q), glm::length(p - q));
        ASSERT_NEAR(distance_up(p, q), glm::length(p - q), 1e-15 * glm::length(p - q));
        ASSERT_GE(static_cast<double>(float_up(a)), a);
        ASSERT_LT(static_cast<double>(std::nextafter(float_up(a), -1e30f)), a);
    }
}

} // namespace
} // namespace collision
