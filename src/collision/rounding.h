#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

// Arithmetic that rounds up: what a sphere must not lose to rounding, it gains; and where nothing is lost, as
// with whole numbers and quarter turns, nothing is gained either. Each result is the smallest double that is
// not below the exact one. Lengths under 1e-140 m may count as none, since their squares vanish.
// Needs arithmetic that is not contracted to fused multiply-add, nor relaxed (-ffp-contract=off, no
// fast-math).

namespace collision {

/// Holds a rounded result and what is missing to the exact one.
struct WithError
{
    double value;
    double error;
};

/// Returns a + b and the error of that, exactly. Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
inline WithError two_sum(double a, double b)
{
    const double sum = a + b;
    const double b_of_sum = sum - a;
    return {sum, (a - (sum - b_of_sum)) + (b - b_of_sum)};
}

/// Returns a * b and the error of that, exactly, for magnitudes between 1e-140 and 1e140. Dekker 1971.
inline WithError two_product(double a, double b)
{
    constexpr double SPLITTER = 134217729.0; // 2^27 + 1 cuts 53 bits into two halves
    const double a_high = SPLITTER * a - (SPLITTER * a - a);
    const double b_high = SPLITTER * b - (SPLITTER * b - b);
    const double a_low = a - a_high;
    const double b_low = b - b_high;
    const double product = a * b;
    return {product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

/// Returns the next double above.
inline double next_up(double x)
{
    return std::nextafter(x, std::numeric_limits<double>::infinity());
}

inline double sum_up(double a, double b)
{
    const WithError sum = two_sum(a, b);
    return sum.error > 0.0 ? next_up(sum.value) : sum.value;
}

inline double product_up(double a, double b)
{
    const WithError product = two_product(a, b);
    return product.error > 0.0 ? next_up(product.value) : product.value;
}

/// Precondition: x >= 0.
inline double sqrt_up(double x)
{
    const double root = std::sqrt(x);
    const WithError square = two_product(root, root);
    const bool is_below = square.value < x || (square.value == x && square.error < 0.0);
    return is_below ? next_up(root) : root;
}

/// Returns the distance of two points, rounded up.
inline double distance_up(const glm::dvec3& a, const glm::dvec3& b)
{
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double difference = a[axis] > b[axis] ? sum_up(a[axis], -b[axis]) : sum_up(b[axis], -a[axis]);
        square = sum_up(square, product_up(difference, difference));
    }
    return sqrt_up(square);
}

/// Returns the smallest float not below x; infinity beyond the largest.
inline float float_up(double x)
{
    const auto nearest = static_cast<float>(x);
    return static_cast<double>(nearest) < x ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                                            : nearest;
}

} // namespace collision
