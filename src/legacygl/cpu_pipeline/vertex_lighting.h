#pragma once

#include "legacygl/cpu_pipeline/shaded_vertex.h"
#include "legacygl/shader/shader_key.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>

namespace legacygl {

/// What the lighting of a vertex reads: its own values, and the uniform arrays that a shader would read.
struct LightingInput
{
    glm::vec3 normal;
    glm::vec4 eye;
    glm::vec4 color;
    std::span<const glm::vec4> transform;
    std::span<const glm::vec4> lighting;
};

/// Lights a vertex (OpenGL 1.5, 2.14.1) as the text of shader_lighting_text.cpp does, operation by
/// operation, since a picture may hold vertices lit by either. Colours are not clamped.
void light_vertex(const ShaderKey& key, const LightingInput& input, Varyings& out);

} // namespace legacygl
