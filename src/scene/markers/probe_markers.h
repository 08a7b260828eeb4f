#pragma once

#include "app/view/frame.h"
#include "scene/markers/marker_pen.h"

namespace scene {

/// Draws what is tested: the point, or the line with its handles and ends, the handle that the keys move
/// marked; and the closest points to the centres of the penetrated spheres, joined to these.
void draw_probe(const app::Frame& frame, const MarkerPen& pen);

} // namespace scene
