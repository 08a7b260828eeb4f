#pragma once

#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace legacygl {

/// What a vertex can carry. The number is also the attribute's location in the shaders.
enum class Attribute : std::uint8_t
{
    position,
    normal,
    color,
    secondary_color,
    fog_coordinate,
    texture_coordinate_0,
    texture_coordinate_1,
    edge_flag, ///< No shader reads it: it decides on the CPU which edges of a polygon are drawn.
    count
};

constexpr int ATTRIBUTE_COUNT = static_cast<int>(Attribute::count);

constexpr int index_of(Attribute attribute)
{
    return static_cast<int>(attribute);
}

/// The values that glNormal, glColor and glTexCoord left (OpenGL 1.5, 2.7); position is unused.
using CurrentAttributes = std::array<glm::vec4, ATTRIBUTE_COUNT>;

/// Returns the initial current values (OpenGL 1.5, table 6.5).
constexpr CurrentAttributes initial_attributes()
{
    constexpr glm::vec4 ZERO = {0, 0, 0, 1};
    return {ZERO, glm::vec4(0, 0, 1, 1), glm::vec4(1, 1, 1, 1), ZERO, glm::vec4(0, 0, 0, 1), ZERO,
            ZERO, glm::vec4(1, 0, 0, 1)};
}

/// How many floats of each attribute a vertex holds, in the order of Attribute, interleaved.
struct VertexFormat
{
    std::array<std::uint8_t, ATTRIBUTE_COUNT> components{}; ///< 0: the attribute is not in the vertex.

    int floats() const
    {
        int sum = 0;
        for (std::uint8_t c : components) {
            sum += c;
        }
        return sum;
    }
    /// Returns where the attribute begins, in floats from the vertex's first.
    int offset(Attribute attribute) const
    {
        int sum = 0;
        for (int i = 0; i < index_of(attribute); ++i) {
            sum += components[i];
        }
        return sum;
    }
    bool has(Attribute attribute) const { return components[index_of(attribute)] != 0; }
    bool operator==(const VertexFormat&) const = default;
};

/// Returns the attribute as one bit of a set of attributes.
constexpr std::uint32_t bit_of(Attribute attribute)
{
    return 1u << index_of(attribute);
}

constexpr int TEXTURE_UNIT_COUNT = 2;

/// Returns the attribute that carries a unit's texture coordinates.
constexpr Attribute texture_coordinate(int unit)
{
    return static_cast<Attribute>(index_of(Attribute::texture_coordinate_0) + unit);
}

constexpr int MAX_VERTEX_FLOATS = 4 * ATTRIBUTE_COUNT;

} // namespace legacygl
