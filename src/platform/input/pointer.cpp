#include "platform/input/pointer.h"

#include "app/commands/commands.h"
#include "app/commands/pointer.h"
#include "app/view/camera_view.h"

#include <cmath>
#include <cstdlib>
#include <glm/vec2.hpp>

namespace platform {
namespace {

/// A hand that clicks may tremble so far, in points.
constexpr int CLICK_REACH = 3;

/// Returns a place in the window as an aim: see app::Projectile.
glm::dvec2 aim_at(int x, int y, WindowSize window)
{
    const double height = window.height;
    return app::heightening(window.width / height) *
           glm::dvec2((x + 0.5 - 0.5 * window.width) / height, 0.5 - (y + 0.5) / height);
}

/// Aims, and does what is done by the aim.
void aim_and(std::string_view command, const glm::dvec2& aim, app::Simulation& simulation)
{
    simulation.apply("aim_x", aim.x);
    simulation.apply("aim_y", aim.y);
    simulation.apply(command, 1.0);
}

} // namespace

void Pointer::press(const SDL_MouseButtonEvent& event, WindowSize window, app::Simulation& simulation)
{
    pressed_x_ = event.x;
    pressed_y_ = event.y;
    drag_ = Drag::click;
    if (const auto handle =
            app::handle_at(simulation.state(), simulation.assets(), aim_at(event.x, event.y, window))) {
        simulation.apply("handle", static_cast<double>(*handle));
        drag_ = Drag::handle;
    }
}

void Pointer::move(const SDL_MouseMotionEvent& event, WindowSize window, app::Simulation& simulation)
{
    if (drag_ == Drag::click &&
        (std::abs(event.x - pressed_x_) > CLICK_REACH || std::abs(event.y - pressed_y_) > CLICK_REACH)) {
        drag_ = Drag::orbit;
    }
    if (drag_ == Drag::handle) {
        aim_and("move_to_aim", aim_at(event.x, event.y, window), simulation);
    } else if (drag_ == Drag::orbit) {
        simulation.apply("orbit_by", -app::DRAG_DEGREES_PER_POINT * event.xrel);
        simulation.apply("tilt_by", app::DRAG_DEGREES_PER_POINT * event.yrel);
    }
}

void Pointer::lift(const SDL_MouseButtonEvent& event, WindowSize window, app::Simulation& simulation)
{
    if (drag_ == Drag::click) {
        aim_and("fire_at_aim", aim_at(event.x, event.y, window), simulation);
    }
    drag_ = Drag::none;
}

void Pointer::handle(const SDL_Event& event, WindowSize window, app::Simulation& simulation)
{
    switch (event.type) {
    case SDL_MOUSEBUTTONDOWN:
        if (event.button.button == SDL_BUTTON_LEFT) {
            press(event.button, window, simulation);
        }
        break;
    case SDL_MOUSEBUTTONUP:
        if (event.button.button == SDL_BUTTON_LEFT) {
            lift(event.button, window, simulation);
        }
        break;
    case SDL_MOUSEMOTION:
        move(event.motion, window, simulation);
        break;
    case SDL_MOUSEWHEEL:
        simulation.apply("zoom_by", static_cast<double>(event.wheel.preciseY));
        break;
    default:
        break;
    }
}

} // namespace platform
