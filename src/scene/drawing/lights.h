#pragma once

#include <glm/vec3.hpp>

namespace scene {

/// Points from anywhere to the sun, of any length: GL_LIGHT0's direction in the world.
inline constexpr glm::vec3 TO_SUN{0.55f, 0.75f, 0.45f};

/// Sets the lights' colours and the materials that stay the same for a whole run: once a context.
void set_up_lights();

/// Returns what the lights give a white surface without gloss, with this normal in the world, of any length
/// but 0: red, green and blue, each at most 1, as OpenGL computes a vertex's colour (OpenGL 1.1, 2.13.1).
glm::vec3 light_on(const glm::vec3& normal);

/// Puts the sun and the sky's fill light where they stand in the world.
/// Call it when the modelview matrix is the view alone: a light's position is transformed by it.
void place_lights();

} // namespace scene
