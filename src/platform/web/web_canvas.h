#pragma once

#include "platform/input/pointer.h"

#include <string>

#include <SDL.h>
#include <legacygl/legacygl.h>

namespace platform {

/// The page's canvas: its size in pixels, its keyboard and its WebGL 2 context.
class WebCanvas
{
public:
    /// Makes the SDL window on "#canvas", the WebGL 2 context and legacygl's in it.
    /// antialias: smooths edges, where the browser can. Call it once.
    /// Returns "" or a sentence that says what the browser lacks.
    std::string open(bool antialias);

    /// Fits the canvas to its element's size on the page. Returns whether its size in pixels changed.
    bool fit();

    int width() const { return width_; }   ///< pixels
    int height() const { return height_; } ///< pixels

    /// Returns the size that the mouse's events are counted in.
    WindowSize size_in_points() const;

    /// Returns whether the context is lost and not yet back.
    bool lost() const { return lost_; }

    /// Returns true once after the context came back: everything has to be drawn again.
    bool take_restored();

private:
    struct Handlers;

    SDL_Window* window_ = nullptr;
    LegacyGLContext* legacygl_ = nullptr;
    int width_ = 1;
    int height_ = 1;
    bool lost_ = false;
    bool restored_ = false;
};

} // namespace platform
