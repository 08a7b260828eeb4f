#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

// Random shapes and motions, the same on every machine. For that, two draws are never operands or arguments
// of one expression, but between braces: compilers take them in different orders.
namespace collision {

class Random
{
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    double uniform(double lowest, double highest)
    {
        return lowest + (highest - lowest) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
    }

    /// Spread about evenly over the orders of magnitude; without a logarithm, which differs between machines.
    double any_size(double smallest, double largest)
    {
        const auto exponents = static_cast<std::size_t>(std::ilogb(largest) - std::ilogb(smallest) + 1);
        const int exponent = std::ilogb(smallest) + static_cast<int>(index(exponents));
        return std::clamp(std::ldexp(uniform(1, 2), exponent), smallest, largest);
    }

    std::size_t index(std::size_t count) { return static_cast<std::size_t>(bits_() % count); }

    glm::dvec3 in_box(double half)
    {
        const double x = uniform(-half, half);
        const double y = uniform(-half, half);
        const double z = uniform(-half, half);
        return {x, y, z};
    }

    glm::dvec3 direction()
    {
        for (;;) {
            const glm::dvec3 v = in_box(1.0);
            const double length = glm::length(v);
            if (length > 0.1 && length <= 1.0) {
                return v / length;
            }
        }
    }

    glm::dmat3 rotation()
    {
        const glm::dvec3 x = direction();
        const glm::dvec3 y = glm::normalize(glm::cross(x, direction()));
        return {x, y, glm::cross(x, y)};
    }

    /// A rotation, then a translation by up to `far` along each axis.
    glm::dmat4 rigid_motion(double far)
    {
        glm::dmat4 matrix(rotation());
        matrix[3] = glm::dvec4(in_box(far), 1.0);
        return matrix;
    }

    std::vector<glm::vec3> points(std::size_t count, const glm::dvec3& centre, double half)
    {
        std::vector<glm::vec3> result;
        for (std::size_t i = 0; i < count; ++i) {
            result.emplace_back(centre + in_box(half));
        }
        return result;
    }

    /// Up to `most` points, at least one, in a cube somewhere within `far` of the origin.
    std::vector<glm::vec3> cloud(std::size_t most, double far, double half)
    {
        const std::size_t count = 1 + index(most);
        const glm::dvec3 centre = in_box(far);
        return points(count, centre, half);
    }

    /// A scale for each axis.
    glm::dvec3 scales(double smallest, double largest)
    {
        const double x = any_size(smallest, largest);
        const double y = any_size(smallest, largest);
        const double z = any_size(smallest, largest);
        return {x, y, z};
    }

    std::mt19937_64& bits() { return bits_; }

private:
    std::mt19937_64 bits_;
};

using Exact = long double; // 64 bits or more of mantissa: enough beside floats and doubles

/// Returns by how much the transformed point is outside the sphere; 0 or less when inside.
inline Exact out_of_sphere(const glm::dvec3& centre, double radius, const glm::mat4& matrix,
                           const glm::dvec3& point)
{
    Exact square = 0;
    for (int row = 0; row < 3; ++row) {
        // The largest numbers first, so that their difference is exact.
        Exact offset = static_cast<Exact>(matrix[3][row]) - static_cast<Exact>(centre[row]);
        for (int column = 0; column < 3; ++column) {
            offset += static_cast<Exact>(matrix[column][row]) * static_cast<Exact>(point[column]);
        }
        square += offset * offset;
    }
    return std::sqrt(square) - static_cast<Exact>(radius);
}

inline Exact out_of_sphere(const glm::dvec3& centre, double radius, const glm::dvec3& point)
{
    return out_of_sphere(centre, radius, glm::mat4(1.0f), point);
}

} // namespace collision
