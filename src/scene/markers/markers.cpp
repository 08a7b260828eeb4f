#include "scene/markers/markers.h"

#include "scene/drawing/materials.h"
#include "scene/drawing/scoped_state.h"
#include "scene/markers/axis_marker.h"
#include "scene/markers/marker_pen.h"
#include "scene/markers/probe_markers.h"
#include "scene/markers/shot_marker.h"
#include "scene/markers/triangle_markers.h"

#include <algorithm>

#include <GL/gl.h>

namespace scene {
namespace {

/// How much is seen of what is hidden.
constexpr float HIDDEN_OPACITY = 0.5f;

/// A line is as wide as this part of the window's height, and no thinner than a pixel.
constexpr float LINE_WIDTH = 1.0f / 300.0f;

void draw_all(const app::Frame& frame, const MarkerPen& pen)
{
    draw_probe(frame, pen);
    draw_triangles(frame, pen);
    draw_shot(frame.shot, pen);
    draw_axis(frame.axis, pen);
}

} // namespace

void draw_markers(const app::Frame& frame, const Shapes& shapes, int window_height)
{
    use_plain_material();
    const Enabled colour_material(GL_COLOR_MATERIAL);
    const LineWidth line_width(std::max(1.0f, LINE_WIDTH * static_cast<float>(window_height)));
    {
        const Enabled blend(GL_BLEND); // for what fades; it writes depth, so that it hides its own ghost
        draw_all(frame, MarkerPen(frame.camera, shapes, 1.0f));
    }
    const Blended blended;
    glDepthFunc(GL_GREATER);
    draw_all(frame, MarkerPen(frame.camera, shapes, HIDDEN_OPACITY));
    glDepthFunc(GL_LEQUAL);
}

} // namespace scene
