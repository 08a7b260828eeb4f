#pragma once

#include "legacygl/context/context.h"

#include <cstdint>
#include <vector>

namespace legacygl {

/// A rectangle of the frame buffer that was asked for, cut down to what exists.
struct PixelRectangle
{
    int x, y, width, height;
    int skipped_left, skipped_below; ///< How much of what was asked lies outside there.
    bool empty() const { return width <= 0 || height <= 0; }
};

/// Cuts a rectangle at the borders of the frame buffer: what lies outside is undefined, and left alone.
PixelRectangle clip_to_frame(const Context& gl, int x, int y, int width, int height);

/// Reads the RGBA bytes of a rectangle of the read buffer, the bottom row first.
std::vector<std::uint8_t> read_frame(Context& gl, const PixelRectangle& rectangle);

} // namespace legacygl
