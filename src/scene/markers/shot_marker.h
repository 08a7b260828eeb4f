#pragma once

#include "app/view/frame.h"
#include "scene/markers/marker_pen.h"

namespace scene {

/// Draws the projectile in flight with a short trail; nothing while none flies.
void draw_shot(const app::ShotInFrame& shot, const MarkerPen& pen);

} // namespace scene
