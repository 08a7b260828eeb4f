#pragma once

#include "legacygl/vertex/material.h"

#include <GL/gl.h>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace legacygl {

constexpr int LIGHT_COUNT = 8;

/// OpenGL 1.5, table 6.12; position and direction are in eye coordinates.
struct Light
{
    bool enabled = false;
    glm::vec4 ambient{0, 0, 0, 1};
    glm::vec4 diffuse{0, 0, 0, 1};
    glm::vec4 specular{0, 0, 0, 1};
    glm::vec4 position{0, 0, 1, 0};
    glm::vec3 spot_direction{0, 0, -1};
    float spot_exponent = 0;
    float spot_cutoff_degrees = 180;
    std::array<float, 3> attenuation{1, 0, 0}; ///< constant, linear, quadratic
};

/// OpenGL 1.5, tables 6.10 to 6.12.
struct LightingState
{
    LightingState() { lights[0].diffuse = lights[0].specular = {1, 1, 1, 1}; }

    bool enabled = false;
    GLenum shade_model = GL_SMOOTH;
    bool color_sum = false; ///< Adds the secondary colour where there is no lighting.
    bool color_material = false;
    GLenum color_material_face = GL_FRONT_AND_BACK;
    GLenum color_material_mode = GL_AMBIENT_AND_DIFFUSE;
    std::array<Material, 2> materials; ///< front, back
    glm::vec4 model_ambient{0.2f, 0.2f, 0.2f, 1};
    bool local_viewer = false;
    bool two_side = false;
    bool separate_specular = false;
    std::array<Light, LIGHT_COUNT> lights;

    /// Sets properties of one or both faces. Returns false when the name is not one of a material.
    bool set_material(GLenum face, GLenum name, const std::array<float, 4>& values);
    /// Returns whether glColor sets this property of this face (0 front, 1 back).
    bool follows_color(int face, MaterialProperty property) const;
};

inline bool LightingState::set_material(GLenum face, GLenum name, const std::array<float, 4>& v)
{
    using enum MaterialProperty;
    const glm::vec4 color = {v[0], v[1], v[2], v[3]};
    for (int side = 0; side < 2; ++side) {
        if (face == (side == 0 ? GL_BACK : GL_FRONT)) {
            continue;
        }
        Material& material = materials[side];
        switch (name) {
        case GL_AMBIENT:
            material[ambient] = color;
            break;
        case GL_DIFFUSE:
            material[diffuse] = color;
            break;
        case GL_SPECULAR:
            material[specular] = color;
            break;
        case GL_EMISSION:
            material[emission] = color;
            break;
        case GL_AMBIENT_AND_DIFFUSE:
            material[ambient] = material[diffuse] = color;
            break;
        case GL_SHININESS:
            material.shininess = v[0];
            break;
        default:
            return false;
        }
    }
    return true;
}

inline bool LightingState::follows_color(int face, MaterialProperty property) const
{
    if (!color_material) {
        return false;
    }
    if (color_material_face != GL_FRONT_AND_BACK && (color_material_face == GL_BACK) != (face == 1)) {
        return false;
    }
    switch (color_material_mode) {
    case GL_AMBIENT:
        return property == MaterialProperty::ambient;
    case GL_DIFFUSE:
        return property == MaterialProperty::diffuse;
    case GL_SPECULAR:
        return property == MaterialProperty::specular;
    case GL_EMISSION:
        return property == MaterialProperty::emission;
    default:
        return property == MaterialProperty::ambient || property == MaterialProperty::diffuse;
    }
}

} // namespace legacygl
