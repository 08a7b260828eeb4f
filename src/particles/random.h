#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace particles {

/// Draws numbers that are the same on every machine: one independent stream for each seed and stream number.
/// SplitMix64, a counter and a mixing function (Steele, Lea, Flood, Fast Splittable Pseudorandom Number
/// Generators, 2014); the distributions need no library function.
class Random
{
public:
    /// Begins stream number `stream` of a seed. Any seed and any number will do.
    Random(std::uint64_t seed, std::uint64_t stream) : state_(mixed(mixed(seed) + stream)) {}

    /// Returns the next 64 bits.
    std::uint64_t next_bits()
    {
        state_ += INCREMENT;
        return mixed(state_);
    }

    /// Returns a number evenly distributed in [0, 1), a multiple of 2^-53.
    double uniform() { return static_cast<double>(next_bits() >> 11) * 0x1p-53; }

    /// Returns a point evenly distributed in the cube [-1, 1)^3.
    glm::dvec3 in_cube()
    {
        // One after the other: compilers evaluate the arguments of a call in different orders.
        const double x = uniform();
        const double y = uniform();
        const double z = uniform();
        return {2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0};
    }

    /// Returns a point evenly distributed in the ball of radius 1, by rejection: no trigonometry, no root.
    glm::dvec3 in_ball()
    {
        for (;;) {
            const glm::dvec3 point = in_cube();
            if (point.x * point.x + point.y * point.y + point.z * point.z <= 1.0) {
                return point;
            }
        }
    }

private:
    static constexpr std::uint64_t INCREMENT = 0x9e3779b97f4a7c15; // 2^64 divided by the golden ratio, odd

    static std::uint64_t mixed(std::uint64_t bits)
    {
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
        return bits ^ (bits >> 31);
    }

    std::uint64_t state_;
};

} // namespace particles
