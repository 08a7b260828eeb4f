#pragma once

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <type_traits>

namespace legacygl {

/// Converts a colour's or normal's component to a float: integers stand for fractions, so that the
/// greatest is 1 (OpenGL 1.5, table 2.9); floating-point values stay.
template <class T> constexpr float component(T value)
{
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<float>(value);
    } else {
        using Unsigned = std::make_unsigned_t<T>;
        constexpr double MAX_VALUE = static_cast<double>(static_cast<Unsigned>(~Unsigned{0}));
        if constexpr (sizeof(T) == 1 && std::is_unsigned_v<T>) {
            return static_cast<float>(value) / 255.0f;
        } else if constexpr (std::is_unsigned_v<T>) {
            return static_cast<float>(static_cast<double>(value) / MAX_VALUE);
        } else {
            return static_cast<float>((2.0 * static_cast<double>(value) + 1.0) / MAX_VALUE);
        }
    }
}

/// Converts a coordinate's component to a float: integers stand for themselves.
template <class T> constexpr float number(T value)
{
    return static_cast<float>(value);
}

/// A vector of up to four components; those left out are (0, 0, 0, 1)'s.
constexpr glm::vec4 vector_of(float x, float y = 0, float z = 0, float w = 1)
{
    return {x, y, z, w};
}

} // namespace legacygl
