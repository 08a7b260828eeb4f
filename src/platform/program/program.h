#pragma once

#include "app/simulation/simulation.h"
#include "assets/assets.h"
#include "assets/users_tank.h"
#include "platform/input/input.h"
#include "platform/program/fixed_step_clock.h"
#include "scene/scene_renderer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <SDL.h>

namespace platform {

/// The running program, whatever it runs in: the state, what turns events into commands, what draws it.
/// It has no clock and no window of its own; the desktop window and the page bring those.
class Program
{
public:
    Program();
    Program(const Program&) = delete; // the simulation points at the assets
    Program& operator=(const Program&) = delete;

    /// Takes the data of the program's own tank and makes what drawing needs. A context must be current. Call
    /// it once. Returns "" or a sentence that says what OpenGL refused.
    std::string start(assets::Assets assets);

    /// Returns whether start() has returned "". What is said below of the simulation holds from then on.
    bool started() const { return started_; }

    /// Shows a tank that the user brought, in place of the one before. Returns "" or a sentence that says
    /// what OpenGL refused; nothing has changed then.
    std::string set_user_tank(assets::Assets own);

    /// Opens a fragment with the tank that start() was given: see platform::open_link_with().
    std::vector<std::string> open_link_with(const assets::UsersTank& tank, std::string_view fragment);

    /// Opens a fragment and returns the messages about it, one sentence each.
    std::vector<std::string> open_link(std::string_view fragment);

    /// Executes a command of the table. Returns "" or a sentence that says why nothing was done.
    std::string command(std::string_view name, double value);

    /// Takes one event of a window of that size.
    void handle(const SDL_Event& event, WindowSize window);

    /// Advances the state by the ticks that `seconds` bring.
    void advance(double seconds);

    /// Draws the state if the last picture shows another one, or another size. width, height: pixels.
    /// Returns whether it drew. Precondition: start() returned "".
    bool draw_if_changed(int width, int height);

    /// Makes the next draw_if_changed draw in any case: the window's content is gone.
    void redraw() { drawn_ = false; }

    const app::Simulation& simulation() const { return *simulation_; }
    const app::State& state() const { return simulation_->state(); }

    /// Returns the data of the tank that is shown, which the renderer has.
    const assets::Assets& assets() const { return simulation_->assets(); }
    const scene::SceneRenderer& renderer() const { return renderer_; }

private:
    void follow(const app::Outcome& outcome);

    assets::Assets lab_;
    std::unique_ptr<const assets::Assets> own_;
    std::optional<app::Simulation> simulation_;
    Input input_;
    FixedStepClock clock_;
    scene::SceneRenderer renderer_;
    bool started_ = false;
    bool drawn_ = false;
    std::uint64_t drawn_revision_ = 0;
    int drawn_width_ = 0;
    int drawn_height_ = 0;
};

} // namespace platform
