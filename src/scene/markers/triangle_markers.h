#pragma once

#include "app/view/frame.h"
#include "scene/markers/marker_pen.h"

namespace scene {

/// Draws the triangles that the probe's point was tested against, each with its nearest point joined to the
/// probe's, in a colour that says whether that is inside the part's mesh.
void draw_triangles(const app::Frame& frame, const MarkerPen& pen);

} // namespace scene
