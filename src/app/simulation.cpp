#include "app/simulation.h"

#include "app/text.h"
#include "app/update.h"

namespace app {

namespace {

bool same_probe(const Projectile& one, const Projectile& other)
{
    return one.probe == other.probe && one.point == other.point && one.radius == other.radius &&
           one.a == other.a && one.b == other.b;
}

} // namespace

Simulation::Simulation(const Assets& assets) : assets_(&assets), spheres_(assets) {}

std::string Simulation::apply(const Command& command, double value)
{
    const State before = state_;
    std::string fault = app::apply(state_, command, value);
    follow(before);
    return fault;
}

std::string Simulation::apply(std::string_view name, double value)
{
    const Command* command = find_command(name);
    return command == nullptr ? "There is no command " + in_quotes(name) + "." : apply(*command, value);
}

void Simulation::step()
{
    const State before = state_;
    app::step(state_, *assets_);
    follow(before);
}

LinkResult Simulation::open_link(std::string_view fragment)
{
    const State before = state_;
    LinkResult result = app::open_link(state_, fragment);
    follow(before);
    return result;
}

/// Brings everything up to date after the state has changed.
void Simulation::follow(const State& before)
{
    const bool has_moved = spheres_.refit(state_);
    const bool is_opened = state_.revision.openings != before.revision.openings;
    const bool is_asked = state_.revision.prints != before.revision.prints;
    if (has_moved || is_opened || is_asked || !same_probe(before.projectile, state_.projectile)) {
        update_report(is_asked);
    }
}

void Simulation::update_report(bool is_asked)
{
    if (state_.projectile.probe == Probe::none && report_.probe == Probe::none && !is_asked) {
        return;
    }
    report_ = hit_report(state_, spheres_.hierarchy());
    log_.print(report_lines(report_), is_asked);
}

} // namespace app
