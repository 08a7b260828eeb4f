#pragma once

#include "app/commands/keys.h"
#include "app/simulation/simulation.h"
#include "platform/input/finger_pinch.h"
#include "platform/input/pointer.h"

#include <bitset>

#include <SDL.h>

namespace platform {

/// Turns SDL's keyboard, mouse and focus events into commands of the one table.
class Input
{
public:
    /// Does what the event asks for and returns what happened; events that mean nothing here are ignored.
    app::Outcome handle(const SDL_Event& event, WindowSize window, app::Simulation& simulation);

    /// Lets go of every key and mouse button, as if the hands had left them.
    app::Outcome release_all(app::Simulation& simulation);

private:
    app::Outcome key_down(const SDL_KeyboardEvent& event, app::Simulation& simulation);
    app::Outcome key_up(const SDL_KeyboardEvent& event, app::Simulation& simulation);
    bool is_down(app::Key key) const;
    app::Outcome finger(const SDL_TouchFingerEvent& event, app::Simulation& simulation);

    std::bitset<SDL_NUM_SCANCODES> down_;
    Pointer pointer_;
    FingerPinch pinch_;
};

} // namespace platform
