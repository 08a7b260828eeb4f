#pragma once

#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace legacygl {

/// Material properties that can vary, in the order of the shaders' products.
enum class MaterialProperty : std::uint8_t
{
    ambient,
    diffuse,
    specular,
    emission,
    count
};
constexpr int MATERIAL_PROPERTY_COUNT = static_cast<int>(MaterialProperty::count);

/// OpenGL 1.5, table 6.11.
struct Material
{
    std::array<glm::vec4, MATERIAL_PROPERTY_COUNT> colors{
        glm::vec4(0.2f, 0.2f, 0.2f, 1), {0.8f, 0.8f, 0.8f, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}};
    float shininess = 0;
    glm::vec4& operator[](MaterialProperty p) { return colors[static_cast<int>(p)]; }
    const glm::vec4& operator[](MaterialProperty p) const { return colors[static_cast<int>(p)]; }
};

} // namespace legacygl
