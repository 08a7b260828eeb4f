#pragma once

#include "legacygl/list/list_geometry.h"

namespace legacygl {

struct Context;

/// Draws a list's vertices where the list is called: in one draw call where that says the same, else
/// vertex by vertex as if the program had given them now. Leaves the current attributes as the list does.
void replay(Context& gl, ListGeometry& geometry);

} // namespace legacygl
