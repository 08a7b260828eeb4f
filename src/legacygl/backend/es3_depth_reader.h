#pragma once

#include "legacygl/backend/es3_fullscreen_pass.h"
#include "legacygl/backend/es3_functions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// A rectangle of a target whose size is known, in pixels.
struct TargetRectangle
{
    int target_width, target_height;
    int x, y, width, height;
};

/// Reads depths and stencil values, which ES cannot read itself: copies them into a framebuffer of its own
/// and draws there what they are into colours. All methods read the framebuffer bound for reading, and change
/// bindings and fixed state, which the caller sets again. They return false when ES refuses the copy, as from
/// a window with antialiasing.
class Es3DepthReader
{
public:
    Es3DepthReader(const Es3Functions& gl, Es3FullscreenPass& fullscreen_pass)
        : gl_(gl), fullscreen_pass_(fullscreen_pass)
    {}

    /// Reads depths in steps of 1 / (2^24 - 1), the bottom row first.
    bool read_depths(const TargetRectangle& from, std::span<std::uint32_t> depths);
    /// Reads stencil values, the bottom row first.
    bool read_stencils(const TargetRectangle& from, std::span<std::uint8_t> values);

private:
    struct Copy;
    std::vector<std::uint32_t> decode(const Copy& copy, int excess, const TargetRectangle& from);
    int excess_of_depths(const Copy& copy, const TargetRectangle& from);

    const Es3Functions& gl_;
    Es3FullscreenPass& fullscreen_pass_;
};

} // namespace legacygl
