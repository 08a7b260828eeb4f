#pragma once

#include <glm/vec4.hpp>

#include <array>

namespace legacygl {

/// A corner of a line drawn as a parallelogram: where it is in pixels, and how far it lies on the way from
/// the line's first to its second end (0 … 1, or a little beyond).
struct LineCorner
{
    float x, y, along;
};

/// Computes the parallelogram whose pixels are those of an aliased line in Mesa's software renderer: the
/// diamond-exit rule (OpenGL 1.5, 3.4.1) at both ends, ends cut along an axis, and a whole number of pixels
/// wide. Corners lie on the grid of 1/256 pixel that such renderers snap to, so that what rasterises them
/// need not compute exactly. Returns false when the line has no length.
bool line_corners(const glm::vec4& first, const glm::vec4& second, float width,
                  std::array<LineCorner, 4>& corners);

} // namespace legacygl
