#include "platform/program/program.h"

#include "app/state/fields.h"
#include "app/state/ticks.h"
#include "app/view/frame.h"
#include "platform/program/users_tank_link.h"

#include <utility>

namespace platform {

Program::Program() : clock_(app::TICKS_PER_SECOND) {}

std::string Program::start(assets::Assets assets)
{
    lab_ = std::move(assets);
    simulation_.emplace(lab_);
    std::string fault = renderer_.load(lab_);
    started_ = fault.empty();
    return fault;
}

std::string Program::set_user_tank(assets::Assets own)
{
    auto brought = std::make_unique<const assets::Assets>(std::move(own));
    drawn_ = false;
    if (std::string fault = renderer_.load_tank(*brought); !fault.empty()) {
        renderer_.load_tank(assets()); // it was there before
        return fault;
    }
    simulation_->set_user_tank(brought.get());
    own_ = std::move(brought);
    return simulation_->apply(app::field(app::FieldId::tank).name, static_cast<double>(app::TankShown::own))
        .refusal;
}

/// Gives the renderer the tank that is shown, where that is another one.
void Program::follow(const app::Outcome& outcome)
{
    if (outcome.tank_replaced) {
        renderer_.load_tank(assets()); // OpenGL has taken it once
        drawn_ = false;
    }
}

std::vector<std::string> Program::open_link_with(const assets::UsersTank& tank, std::string_view fragment)
{
    return platform::open_link_with(*simulation_, tank, fragment);
}

std::vector<std::string> Program::open_link(std::string_view fragment)
{
    app::LinkResult result = simulation_->open_link(fragment);
    follow(result.outcome);
    return std::move(result.messages);
}

std::string Program::command(std::string_view name, double value)
{
    app::Outcome outcome = simulation_->apply(name, value);
    follow(outcome);
    return std::move(outcome.refusal);
}

void Program::handle(const SDL_Event& event, WindowSize window)
{
    follow(input_.handle(event, window, *simulation_));
}

void Program::advance(double seconds)
{
    for (int tick = clock_.ticks_after(seconds); tick > 0; --tick) {
        simulation_->step();
    }
}

bool Program::draw_if_changed(int width, int height)
{
    const bool shown = drawn_ && drawn_revision_ == simulation_->revision() && drawn_width_ == width &&
                       drawn_height_ == height;
    if (shown) {
        return false;
    }
    renderer_.draw(simulation_->frame(), width, height);
    drawn_ = true;
    drawn_revision_ = simulation_->revision();
    drawn_width_ = width;
    drawn_height_ = height;
    return true;
}

} // namespace platform
