#pragma once

namespace scene {

/// Sets the lights' colours and the materials that stay the same for a whole run: once a context.
void set_up_lights();

/// Puts the sun and the sky's fill light where they stand in the world.
/// Call it when the modelview matrix is the view alone: a light's position is transformed by it.
void place_lights();

} // namespace scene
