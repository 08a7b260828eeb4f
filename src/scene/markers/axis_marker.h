#pragma once

#include "app/view/frame.h"
#include "scene/markers/marker_pen.h"

namespace scene {

/// Draws the axis a part turns about, as an arrow through its pivot; nothing when none is shown.
void draw_axis(const app::AxisInFrame& axis, const MarkerPen& pen);

} // namespace scene
