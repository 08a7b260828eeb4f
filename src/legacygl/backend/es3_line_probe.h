#pragma once

#include "legacygl/backend/es3_functions.h"

namespace legacygl {

/// Draws lines whose ends are far outside of the view volume and behind the eye, and returns whether they
/// show where they cross the view (OpenGL 1.5, 2.12). Mesa's software renderer, 25 and 26 at least, cuts no
/// line at the sides of the view for ES; such lines then are lost, or lie elsewhere. The context is current.
/// Leaves the frame buffers bound as they were, and all other state undefined.
bool clips_lines(const Es3Functions& gl);

} // namespace legacygl
