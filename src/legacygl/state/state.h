#pragma once

#include "legacygl/state/fragment.h"
#include "legacygl/state/lighting.h"
#include "legacygl/state/raster.h"
#include "legacygl/state/texturing.h"
#include "legacygl/state/transform.h"
#include "legacygl/vertex_format.h"

namespace legacygl {

/// All of OpenGL's state, grouped as the specification's state tables (OpenGL 1.5, chapter 6) group it.
/// Queries are answered from here, never from the driver.
struct State
{
    CurrentAttributes current = initial_attributes();
    TransformState transform;
    LightingState lighting;
    RasterState raster;
    TexturingState texturing;
    FogState fog;
    FragmentState fragment;
    PixelStore pack;
    PixelStore unpack;
};

} // namespace legacygl
