#pragma once

#include "app/simulation/simulation.h"

#include <SDL.h>

namespace platform {

/// The size of the window in the units of its mouse events, both at least 1.
struct WindowSize
{
    int width;
    int height;
};

/// Turns the mouse into commands: a drag that begins on the projectile or an end of its line moves that, any
/// other goes round the tank; a click fires from the eye through the pointer; the wheel goes nearer.
class Pointer
{
public:
    /// Does what a mouse event asks for and returns what happened; other events are ignored.
    app::Outcome handle(const SDL_Event& event, WindowSize window, app::Simulation& simulation);

    /// Ends what is going on, without a click.
    void release() { drag_ = Drag::none; }

private:
    enum class Drag : std::uint8_t
    {
        none,
        click, ///< not far enough to be a drag yet
        orbit,
        handle,
    };

    app::Outcome press(const SDL_MouseButtonEvent& event, WindowSize window, app::Simulation& simulation);
    app::Outcome move(const SDL_MouseMotionEvent& event, WindowSize window, app::Simulation& simulation);
    app::Outcome release_over(const SDL_MouseButtonEvent& event, WindowSize window,
                              app::Simulation& simulation);

    Drag drag_ = Drag::none;
    int pressed_x_ = 0;
    int pressed_y_ = 0;
};

} // namespace platform
