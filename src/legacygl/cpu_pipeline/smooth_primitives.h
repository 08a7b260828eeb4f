#pragma once

#include "legacygl/cpu_pipeline/raster_output.h"

namespace legacygl {

/// Draws a line with smooth edges: a quadrilateral half a pixel longer to both sides and about a pixel wider
/// than the line, whose alpha falls from 1 to 0 over its last pixel. That is Mesa's quality, not exact
/// coverage (OpenGL 1.5, 3.4.4, leaves it open).
void add_smooth_line(const ShadedVertex& a, const ShadedVertex& b, float width, RasterOutput& out);

/// Draws a point as a disc whose alpha falls from 1 to 0 over its last pixel (OpenGL 1.5, 3.3). attenuated:
/// its size comes from its distance; it is then drawn no smaller than a pixel across, and else than two.
void add_smooth_point(const ShadedVertex& vertex, bool attenuated, RasterOutput& out);

} // namespace legacygl
