#pragma once

#include <glm/vec3.hpp>

namespace scene {

/// Points from anywhere to the sun, of any length: GL_LIGHT0's direction in the world.
inline constexpr glm::vec3 TO_SUN{0.55f, 0.75f, 0.45f};

/// Sets the lights' colours and the materials that stay the same for a whole run: once a context.
void set_up_lights();

/// Puts the sun and the sky's fill light where they stand in the world.
/// Call it when the modelview matrix is the view alone: a light's position is transformed by it.
void place_lights();

} // namespace scene
