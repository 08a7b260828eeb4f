#include "platform/input/input.h"

#include "app/commands/commands.h"
#include "app/commands/keys.h"

#include <algorithm>

namespace platform {
namespace {

/// The share of the window's side that two fingers move apart for one notch of the wheel.
constexpr double PINCH_PER_NOTCH = 0.05;

} // namespace

bool Input::is_down(app::Key key) const
{
    return key != app::Key::none && down_[static_cast<std::size_t>(key)];
}

app::Outcome Input::key_down(const SDL_KeyboardEvent& event, app::Simulation& simulation)
{
    // With a modifier the key belongs to the window system or the browser (reload, find, copy).
    const bool modified = (event.keysym.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0;
    const app::Key key = app::key_from_number(event.keysym.scancode);
    const app::Command* command = app::command_for_key(key);
    if (event.repeat != 0 || modified || command == nullptr) {
        return {};
    }
    const bool held_already =
        std::any_of(command->keys.begin(), command->keys.end(), [this](app::Key k) { return is_down(k); });
    down_.set(static_cast<std::size_t>(event.keysym.scancode));
    return held_already ? app::Outcome{} : simulation.apply(*command, 1.0);
}

app::Outcome Input::key_up(const SDL_KeyboardEvent& event, app::Simulation& simulation)
{
    const auto scancode = static_cast<std::size_t>(event.keysym.scancode);
    if (scancode >= down_.size() || !down_[scancode]) {
        return {};
    }
    down_.reset(scancode);
    const app::Command* command = app::command_for_key(app::key_from_number(event.keysym.scancode));
    // Two keys may give one command: it ends with the last of them.
    if (command != nullptr &&
        std::none_of(command->keys.begin(), command->keys.end(), [this](app::Key k) { return is_down(k); })) {
        return simulation.apply(*command, 0.0);
    }
    return {};
}

app::Outcome Input::release_all(app::Simulation& simulation)
{
    app::Outcome outcome;
    for (const app::Command& command : app::commands()) {
        if (std::any_of(command.keys.begin(), command.keys.end(),
                        [this](app::Key k) { return is_down(k); })) {
            outcome |= simulation.apply(command, 0.0);
        }
    }
    down_.reset();
    pointer_.release();
    return outcome;
}

app::Outcome Input::finger(const SDL_TouchFingerEvent& event, app::Simulation& simulation)
{
    // SDL lets the first finger drag as a mouse would; the second one ends that, or both would turn the view.
    app::Outcome outcome;
    if (const std::optional<double> spread = pinch_.handle(event)) {
        outcome = simulation.apply("zoom_by", *spread / PINCH_PER_NOTCH);
    }
    if (pinch_.fingers_down() > 1) {
        pointer_.release();
    }
    return outcome;
}

app::Outcome Input::handle(const SDL_Event& event, WindowSize window, app::Simulation& simulation)
{
    app::Outcome outcome = pointer_.handle(event, window, simulation);
    switch (event.type) {
    case SDL_KEYDOWN:
        outcome |= key_down(event.key, simulation);
        break;
    case SDL_KEYUP:
        outcome |= key_up(event.key, simulation);
        break;
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP:
        outcome |= finger(event.tfinger, simulation);
        break;
    case SDL_WINDOWEVENT:
        if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
            outcome |= release_all(simulation);
        }
        break;
    default:
        break;
    }
    return outcome;
}

} // namespace platform
