#pragma once

#include "app/keys.h"
#include "app/state.h"
#include "platform/finger_pinch.h"

#include <bitset>

#include <SDL.h>

namespace platform {

/// Turns SDL's keyboard, mouse and focus events into commands of the one table.
class Input
{
public:
    /// Does what the event asks for; events that mean nothing here are ignored.
    void handle(const SDL_Event& event, app::State& state);

    /// Lets go of every key and mouse button, as if the hands had left them.
    void release_all(app::State& state);

private:
    void key_down(const SDL_KeyboardEvent& event, app::State& state);
    void key_up(const SDL_KeyboardEvent& event, app::State& state);
    bool is_down(app::Key key) const;
    void finger(const SDL_TouchFingerEvent& event, app::State& state);

    std::bitset<SDL_NUM_SCANCODES> down_;
    bool dragging_ = false;
    FingerPinch pinch_;
};

} // namespace platform
