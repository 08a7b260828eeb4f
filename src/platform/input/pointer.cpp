#include "platform/input/pointer.h"

#include "app/commands/commands.h"
#include "app/commands/pointer.h"
#include "app/view/camera_view.h"

#include <cmath>
#include <cstdlib>
#include <glm/vec2.hpp>
#include <utility>

namespace platform {
namespace {

/// A hand that clicks may tremble so far, in points.
constexpr int CLICK_REACH = 3;

/// Returns a place in the window as an aim: see app::Projectile.
glm::dvec2 aim_at(int x, int y, WindowSize window)
{
    const double height = window.height;
    return app::vertical_fov_scale(window.width / height) *
           glm::dvec2((x + 0.5 - 0.5 * window.width) / height, 0.5 - (y + 0.5) / height);
}

/// Aims, and does what is done by the aim.
app::Outcome aim_and(std::string_view command, const glm::dvec2& aim, app::Simulation& simulation)
{
    app::Outcome outcome = simulation.apply("aim_x", aim.x);
    outcome |= simulation.apply("aim_y", aim.y);
    outcome |= simulation.apply(command, 1.0);
    return outcome;
}

} // namespace

app::Outcome Pointer::press(const SDL_MouseButtonEvent& event, WindowSize window, app::Simulation& simulation)
{
    pressed_x_ = event.x;
    pressed_y_ = event.y;
    drag_ = Drag::click;
    if (const auto handle =
            app::handle_at(simulation.state(), simulation.assets(), aim_at(event.x, event.y, window))) {
        drag_ = Drag::handle;
        return simulation.apply("handle", static_cast<double>(*handle));
    }
    return {};
}

app::Outcome Pointer::move(const SDL_MouseMotionEvent& event, WindowSize window, app::Simulation& simulation)
{
    if (drag_ == Drag::click &&
        (std::abs(event.x - pressed_x_) > CLICK_REACH || std::abs(event.y - pressed_y_) > CLICK_REACH)) {
        drag_ = Drag::orbit;
    }
    if (drag_ == Drag::handle) {
        return aim_and("move_to_aim", aim_at(event.x, event.y, window), simulation);
    }
    app::Outcome outcome;
    if (drag_ == Drag::orbit) {
        outcome |= simulation.apply("orbit_by", -app::DRAG_DEGREES_PER_POINT * event.xrel);
        outcome |= simulation.apply("tilt_by", app::DRAG_DEGREES_PER_POINT * event.yrel);
    }
    return outcome;
}

app::Outcome Pointer::release_over(const SDL_MouseButtonEvent& event, WindowSize window,
                                   app::Simulation& simulation)
{
    const Drag ended = std::exchange(drag_, Drag::none);
    return ended == Drag::click ? aim_and("fire_at_aim", aim_at(event.x, event.y, window), simulation)
                                : app::Outcome{};
}

app::Outcome Pointer::handle(const SDL_Event& event, WindowSize window, app::Simulation& simulation)
{
    switch (event.type) {
    case SDL_MOUSEBUTTONDOWN:
        if (event.button.button == SDL_BUTTON_LEFT) {
            return press(event.button, window, simulation);
        }
        break;
    case SDL_MOUSEBUTTONUP:
        if (event.button.button == SDL_BUTTON_LEFT) {
            return release_over(event.button, window, simulation);
        }
        break;
    case SDL_MOUSEMOTION:
        return move(event.motion, window, simulation);
    case SDL_MOUSEWHEEL:
        return simulation.apply("zoom_by", static_cast<double>(event.wheel.preciseY));
    default:
        break;
    }
    return {};
}

} // namespace platform
