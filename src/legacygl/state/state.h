#pragma once

#include "legacygl/state/fragment.h"
#include "legacygl/state/lighting.h"
#include "legacygl/state/pixel_store.h"
#include "legacygl/state/raster.h"
#include "legacygl/state/texturing.h"
#include "legacygl/state/transform.h"
#include "legacygl/vertex/format.h"

namespace legacygl {

/// OpenGL 1.5, table 6.24. Nothing here is quicker for being worse: hints are kept and have no effect.
struct HintState
{
    GLenum perspective_correction = GL_DONT_CARE;
    GLenum point_smooth = GL_DONT_CARE;
    GLenum line_smooth = GL_DONT_CARE;
    GLenum polygon_smooth = GL_DONT_CARE;
    GLenum fog = GL_DONT_CARE;
    GLenum generate_mipmap = GL_DONT_CARE;
    GLenum texture_compression = GL_DONT_CARE;
};

/// OpenGL 1.5, table 6.14; a target has one sample a pixel, so that none of it shows.
struct MultisampleState
{
    bool enabled = true;
    bool alpha_to_coverage = false;
    bool alpha_to_one = false;
    bool coverage = false;
    GLfloat coverage_value = 1;
    bool coverage_invert = false;
};

/// What colour indices have of their own; a target has colours, so that none of it shows.
struct ColorIndexState
{
    GLfloat current = 1;
    GLuint write_mask = ~0u;
    GLfloat clear = 0;
};

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
    HintState hints;
    MultisampleState multisample;
    ColorIndexState color_index;
    bool auto_normal = false; ///< Of evaluators, which are not implemented.
    GLuint list_base = 0;
};

} // namespace legacygl
