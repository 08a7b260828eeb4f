#include "platform/program.h"

#include "app/frame.h"
#include "app/links.h"
#include "app/update.h"

#include <utility>

namespace platform {

Program::Program() : clock_(app::TICKS_PER_SECOND) {}

std::string Program::start(app::Assets assets)
{
    assets_ = std::move(assets);
    return renderer_.load(assets_);
}

std::vector<std::string> Program::open_link(std::string_view fragment)
{
    return app::open_link(state_, fragment).messages;
}

std::string Program::command(std::string_view name, double value)
{
    return app::apply(state_, name, value);
}

void Program::handle(const SDL_Event& event)
{
    input_.handle(event, state_);
}

void Program::advance(double seconds)
{
    for (int tick = clock_.ticks_after(seconds); tick > 0; --tick) {
        app::step(state_, assets_);
    }
}

bool Program::draw_if_changed(int width, int height)
{
    const bool shown = drawn_ && drawn_revision_ == state_.revision.count && drawn_width_ == width &&
                       drawn_height_ == height;
    if (shown) {
        return false;
    }
    renderer_.draw(app::make_frame(state_, assets_), width, height);
    drawn_ = true;
    drawn_revision_ = state_.revision.count;
    drawn_width_ = width;
    drawn_height_ = height;
    return true;
}

} // namespace platform
