#include "collision/closest_point.h"

#include "tests/collision/random_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace collision {
namespace {

void expect_closest(const ClosestPoint& closest, const glm::dvec3& point, double parameter)
{
    EXPECT_EQ(closest.point, point);
    EXPECT_EQ(closest.parameter, parameter);
}

TEST(ClosestPointTest, OfASegmentIsBesideItOrOneOfItsEnds)
{
    const glm::dvec3 a(1, 0, 0);
    const glm::dvec3 b(5, 0, 0);
    expect_closest(closest_point_on_segment({2, 3, 0}, a, b), {2, 0, 0}, 0.25);
    expect_closest(closest_point_on_segment({-9, 3, 4}, a, b), a, 0);
    expect_closest(closest_point_on_segment({1, 3, 4}, a, b), a, 0);
    expect_closest(closest_point_on_segment({5, -1, 0}, a, b), b, 1);
    expect_closest(closest_point_on_segment({99, 0, 0}, a, b), b, 1);
    expect_closest(closest_point_on_segment({3, 0, 0}, a, b), {3, 0, 0}, 0.5);
}

TEST(ClosestPointTest, OfASegmentWithoutLengthIsItsPoint)
{
    expect_closest(closest_point_on_segment({2, 3, 0}, {1, 1, 1}, {1, 1, 1}), {1, 1, 1}, 0);
    expect_closest(closest_point_on_ray({2, 3, 0}, {1, 1, 1}, {0, 0, 0}), {1, 1, 1}, 0);
    expect_closest(closest_point_on_line({2, 3, 0}, {1, 1, 1}, {0, 0, 0}), {1, 1, 1}, 0);
    expect_closest(closest_point_on_line({2, 3, 0}, {1, 1, 1}, {1e-170, 0, 0}), {1, 1, 1}, 0);
    const ClosestPoint short_one = closest_point_on_segment({2, 1, 1}, {1, 1, 1}, {1, 1, 1 + 1e-15});
    EXPECT_EQ(short_one.point, glm::dvec3(1, 1, 1));
}

TEST(ClosestPointTest, OfARayThatLeavesIsItsOrigin)
{
    expect_closest(closest_point_on_ray({0, 4, 0}, {1, 0, 0}, {2, 0, 0}), {1, 0, 0}, 0);
    expect_closest(closest_point_on_ray({9, 4, 0}, {1, 0, 0}, {2, 0, 0}), {9, 0, 0}, 4);
}

TEST(ClosestPointTest, OfALineHasNoEnds)
{
    expect_closest(closest_point_on_line({-9, 4, 0}, {1, 0, 0}, {2, 0, 0}), {-9, 0, 0}, -5);
    expect_closest(closest_point_on_line({9, 4, 0}, {1, 0, 0}, {2, 0, 0}), {9, 0, 0}, 4);
}

TEST(ClosestPointTest, FloatsAreTakenAsTheyAre)
{
    const glm::vec3 p(0.1f, 1, 0);
    expect_closest(closest_point_on_segment(p, glm::vec3(0, 0, 0), glm::vec3(1, 0, 0)),
                   {static_cast<double>(0.1f), 0, 0}, static_cast<double>(0.1f));
}

TEST(ClosestPointTest, NoOtherPointIsCloser)
{
    Random random(30);
    for (int i = 0; i < 5000; ++i) {
        const double size = random.any_size(1e-3, 1e3);
        const glm::dvec3 p = random.in_box(size);
        const glm::dvec3 a = random.in_box(size);
        const glm::dvec3 b = random.in_box(size);
        const ClosestPoint on_segment = closest_point_on_segment(p, a, b);
        const ClosestPoint on_ray = closest_point_on_ray(p, a, b - a);
        const ClosestPoint on_line = closest_point_on_line(p, a, b - a);
        ASSERT_GE(on_segment.parameter, 0);
        ASSERT_LE(on_segment.parameter, 1);
        const double slack = 1e-12 * size;
        ASSERT_LE(glm::distance(on_segment.point, a + on_segment.parameter * (b - a)), slack);
        for (int j = 0; j <= 20; ++j) {
            const double t = j / 20.0;
            const auto at = [&](double parameter) { return glm::distance(p, a + parameter * (b - a)); };
            ASSERT_LE(glm::distance(p, on_segment.point), at(t) + slack);
            ASSERT_LE(glm::distance(p, on_ray.point), at(10 * t) + slack);
            ASSERT_LE(glm::distance(p, on_line.point), at(20 * t - 10) + slack);
        }
        ASSERT_LE(glm::distance(p, on_line.point), glm::distance(p, on_ray.point) + slack);
        ASSERT_LE(glm::distance(p, on_ray.point), glm::distance(p, on_segment.point) + slack);
    }
}

TEST(ClosestPointTest, MovesAlongWithARigidMotion)
{
    Random random(31);
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 p = random.in_box(10);
        const glm::dvec3 a = random.in_box(10);
        const glm::dvec3 b = random.in_box(10);
        const glm::dmat4 motion = random.rigid_motion(i % 2 == 0 ? 100 : 1e6);
        const auto moved = [&](const glm::dvec3& v) { return glm::dvec3(motion * glm::dvec4(v, 1)); };
        const ClosestPoint before = closest_point_on_segment(p, a, b);
        const ClosestPoint after = closest_point_on_segment(moved(p), moved(a), moved(b));
        ASSERT_LE(glm::distance(after.point, moved(before.point)), i % 2 == 0 ? 1e-12 : 1e-8) << i;
    }
}

TEST(ClosestPointTest, ALongLinePassesACentimetreAwayToTheNanometre)
{
    // 2,000 km long, passing 0.01 m beside the origin.
    for (const double y : {0.01, -0.01, 0.0}) {
        const ClosestPoint closest = closest_point_on_segment({0, 0, 0}, {-1e6, y, 1e6}, {1e6, y, -1e6});
        EXPECT_NEAR(glm::length(closest.point), std::abs(y), 1e-9);
        EXPECT_NEAR(closest.parameter, 0.5, 1e-12);
    }
}

} // namespace
} // namespace collision
