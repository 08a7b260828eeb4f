#pragma once

#include "platform/offscreen/render_options.h"

#include <memory>
#include <string>

namespace platform {

/// A picture in memory that gl* calls draw into. Opening one makes it current.
/// Each executable links one of two makers: `legacygl` on OpenGL ES 3 (offscreen_target_emulated.cpp) or
/// the system's own OpenGL (offscreen_target_reference.cpp); the program above them is the same.
class OffscreenTarget
{
public:
    virtual ~OffscreenTarget() = default;
};

/// Makes a target of width x height pixels: colour RGBA8, depth 24 and stencil 8 bits, no antialiasing.
/// Returns nullptr and sets `error` to a sentence when it cannot.
std::unique_ptr<OffscreenTarget> open_offscreen_target(int width, int height, std::string& error);

/// Returns which of the two makers this executable was linked with.
RendererName offscreen_renderer();

} // namespace platform
