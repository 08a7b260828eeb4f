#pragma once

#include "app/view/frame.h"
#include "scene/drawing/shapes.h"

namespace scene {

/// Draws the bounding spheres of a frame: penetrated ones transparent, the others as wire, each level in its
/// own colour. The modelview matrix is the view. After everything that hides what is behind it.
void draw_spheres(const app::Frame& frame, const Shapes& shapes);

} // namespace scene
