#pragma once

#include "app/view/camera_view.h"

namespace scene {

/// Draws the cross of a gunner's sight over the middle of a viewport, above everything. After everything
/// else. height: of the viewport, pixels.
void draw_reticle(const app::CameraView& camera, int height);

} // namespace scene
