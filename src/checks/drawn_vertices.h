#pragma once

#include "app/view/camera_view.h"
#include "checks/frame_capture.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace checks {

/// What a vertex is part of, by the mode given to glBegin.
enum class Drawn : std::uint8_t
{
    points,
    lines,
    faces,
};

/// A vertex as a frame gave it to OpenGL, with what was set then.
struct DrawnVertex
{
    glm::dvec3 world; ///< metres
    Drawn drawn;
    bool blended;
    bool lit;
    bool textured;
    bool writes_depth;
    double opacity; ///< of the current colour
};

/// Returns the vertices given between glBegin and glEnd, in their order, those of lists included.
/// camera: of the frame that was captured. What a frame does not set counts as OpenGL begins with.
std::vector<DrawnVertex> drawn_vertices(const FrameCapture& capture, const app::CameraView& camera);

} // namespace checks
