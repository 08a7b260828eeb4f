#include "tank/rotation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace tank {
namespace {

/// The matrix of the glRotate manual page, written out: rows as printed there.
glm::dmat4 gl_rotate_as_specified(glm::dvec3 axis, double radians)
{
    const glm::dvec3 u = glm::normalize(axis);
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    const double rows[3][3] = {
        {u.x * u.x * (1 - c) + c, u.x * u.y * (1 - c) - u.z * s, u.x * u.z * (1 - c) + u.y * s},
        {u.y * u.x * (1 - c) + u.z * s, u.y * u.y * (1 - c) + c, u.y * u.z * (1 - c) - u.x * s},
        {u.x * u.z * (1 - c) - u.y * s, u.y * u.z * (1 - c) + u.x * s, u.z * u.z * (1 - c) + c},
    };
    glm::dmat4 matrix(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            matrix[column][row] = rows[row][column];
        }
    }
    return matrix;
}

double largest_difference(const glm::dmat4& a, const glm::dmat4& b)
{
    double largest = 0.0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
        }
    }
    return largest;
}

TEST(RotationTest, IsGlRotatesMatrixForAnyAxis)
{
    std::mt19937 random(1);
    const auto next = [&random] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
    for (int i = 0; i < 2000; ++i) {
        glm::dvec3 axis;
        axis.x = next();
        axis.y = next();
        axis.z = next();
        const double angle = next() * 10.0;
        ASSERT_LT(largest_difference(rotation(axis, angle), gl_rotate_as_specified(axis, angle)), 1e-14);
    }
}

TEST(RotationTest, PureAxesKeepExactZerosAndOnes)
{
    const double angle = 0.7;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    using M = glm::dmat4;
    EXPECT_EQ(rotation({1, 0, 0}, angle), M(1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1));
    EXPECT_EQ(rotation({-1, 0, 0}, angle), M(1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1));
    EXPECT_EQ(rotation({0, 1, 0}, angle), M(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1));
    EXPECT_EQ(rotation({0, -1, 0}, angle), M(c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1));
    EXPECT_EQ(rotation({0, 0, 1}, angle), M(c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    EXPECT_EQ(rotation({0, 0, -1}, angle), M(c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    EXPECT_EQ(rotation({0, 5, 0}, angle), rotation({0, 1, 0}, angle));
}

TEST(RotationTest, AZeroAxisTurnsNothing)
{
    EXPECT_EQ(rotation({0, 0, 0}, 1.0), glm::dmat4(1.0));
}

} // namespace
} // namespace tank
