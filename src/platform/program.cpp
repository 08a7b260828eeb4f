#include "platform/program.h"

#include "app/frame.h"
#include "app/ticks.h"

#include <utility>

namespace platform {

Program::Program() : clock_(app::TICKS_PER_SECOND) {}

std::string Program::start(app::Assets assets)
{
    assets_ = std::move(assets);
    simulation_.emplace(assets_);
    std::string fault = renderer_.load(assets_);
    started_ = fault.empty();
    return fault;
}

std::vector<std::string> Program::open_link(std::string_view fragment)
{
    return simulation_->open_link(fragment).messages;
}

std::string Program::command(std::string_view name, double value)
{
    return simulation_->apply(name, value);
}

void Program::handle(const SDL_Event& event, WindowSize window)
{
    input_.handle(event, window, *simulation_);
}

void Program::advance(double seconds)
{
    for (int tick = clock_.ticks_after(seconds); tick > 0; --tick) {
        simulation_->step();
    }
}

bool Program::draw_if_changed(int width, int height)
{
    const bool shown = drawn_ && drawn_revision_ == state().revision.count && drawn_width_ == width &&
                       drawn_height_ == height;
    if (shown) {
        return false;
    }
    renderer_.draw(simulation_->frame(), width, height);
    drawn_ = true;
    drawn_revision_ = state().revision.count;
    drawn_width_ = width;
    drawn_height_ = height;
    return true;
}

} // namespace platform
