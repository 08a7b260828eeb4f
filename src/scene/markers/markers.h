#pragma once

#include "app/view/frame.h"
#include "scene/drawing/shapes.h"

namespace scene {

/// Draws everything that marks something in a frame: the probe, closest points, triangles, the projectile in
/// flight, an axis. What the tank hides shows faintly through it. The modelview matrix is the view.
/// After the spheres, so that they do not tint it. window_height: pixels.
void draw_markers(const app::Frame& frame, const Shapes& shapes, int window_height);

} // namespace scene
