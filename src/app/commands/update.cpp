#include "app/commands/update.h"

#include "app/commands/driving.h"
#include "app/state/flight.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace app {

namespace {

/// More than this many steps at once reach every limit of a relative move anyway.
constexpr double MAX_RELATIVE_STEPS = 200.0;

/// An amount beyond this reaches every limit, and cannot overflow.
constexpr double MAX_AMOUNT = 1e9;

/// Multiplies by 1 + growth, or divides by 1 - growth when growth < 0, so that both directions undo each
/// other.
double grown(double value, double growth)
{
    return growth < 0.0 ? value / (1.0 - growth) : value * (1.0 + growth);
}

/// Grows a number of times, the last by a fraction. Without pow, whose last bit differs between libraries.
double grown_times(double value, double growth, double times)
{
    const double towards = times < 0.0 ? -growth : growth;
    const double size = std::min(std::fabs(times), MAX_RELATIVE_STEPS);
    const int whole = static_cast<int>(size);
    for (int i = 0; i < whole; ++i) {
        value = grown(value, towards);
    }
    return grown(value, towards * (size - whole));
}

/// Says which field a move is about in a state, and how many times its rate.
struct Moved
{
    const Field& field;
    double factor = 1.0;
};

/// The commands for the point are also those for the line's ends, and those that go round the tank turn what
/// is looked through: behind the tank that about it, at the sight the turret and the gun, so that a drag
/// takes the picture along and no handwheel is faster than the keys of the turret.
Moved moved_by(const State& state, const Move& move)
{
    if (state.camera.view == View::follow && move.field == FieldId::orbit) {
        return {field(FieldId::chase)};
    }
    if (state.camera.view == View::gunner && move.field == FieldId::orbit) {
        return {field(FieldId::turret), -0.3};
    }
    if (state.camera.view == View::gunner && move.field == FieldId::tilt) {
        return {field(FieldId::main_gun), 0.3};
    }
    if (!move.of_handle) {
        return {field(move.field)};
    }
    // The coordinates of the point and of both ends are rows of the table in this order, each x, y, z.
    const auto axis = static_cast<std::size_t>(move.field) - static_cast<std::size_t>(FieldId::point_x);
    constexpr FieldId FIRST[] = {FieldId::point_x, FieldId::line_ax, FieldId::line_bx};
    const FieldId first = FIRST[static_cast<std::size_t>(state.projectile.handle)];
    return {fields()[static_cast<std::size_t>(first) + axis]};
}

/// Sets a field and notes whether that changed it.
void change(State& state, const Field& target, double value, FieldSet& changed)
{
    const double old = target.get(state);
    target.set(state, value);
    if (target.get(state) != old) {
        changed.set(static_cast<std::size_t>(target.id));
    }
}

void add(State& state, const Move& move, double amount, FieldSet& changed)
{
    const auto [target, factor] = moved_by(state, move);
    const double old = target.get(state);
    const double bounded = std::clamp(amount, -MAX_AMOUNT, MAX_AMOUNT);
    const double moved =
        move.relative ? grown_times(old, move.rate, bounded) : old + bounded * move.rate * factor;
    change(state, target, within_limits(target, moved), changed);
}

/// Ends the event if a field that it depends on has changed.
void end_event_if_changed(State& state, Outcome& outcome)
{
    if (state.event.kind == EventKind::none) {
        return;
    }
    for (const Field& field : fields()) {
        if (outcome.fields.test(static_cast<std::size_t>(field.id)) && matters_to_replay(field)) {
            state.event = {};
            outcome.event_changed = true;
            return;
        }
    }
}

/// Lets the eye behind the tank stay where it is while the tank turns away under it, and swing back: by so
/// much of the way each second. heading: before this tick.
void swing_behind(State& state, double heading, FieldSet& changed)
{
    constexpr double SHARE_PER_SECOND = 1.8;
    if (state.camera.view != View::follow) {
        return;
    }
    const Field& chase = field(FieldId::chase);
    const double old = chase.get(state);
    const double left_behind = within_limits(chase, old + heading - state.joints[tank::Joint::heading]);
    const double swung = left_behind * (1.0 - SHARE_PER_SECOND / TICKS_PER_SECOND);
    // What no link can say is no swing any more: the picture comes to rest.
    change(state, chase, to_grid(chase, swung) == 0 ? 0.0 : swung, changed);
}

std::string faulty_value(const Command& command, double value)
{
    if (!std::isfinite(value)) {
        return std::string(command.name) + " needs a number, not " +
               (std::isnan(value) ? "NaN" : "infinity") + ".";
    }
    const bool is_switch = command.kind == CommandKind::hold || command.kind == CommandKind::press;
    if (is_switch && value != 0.0 && value != 1.0) {
        return std::string(command.name) + " takes 1 when it begins and 0 when it ends, nothing else.";
    }
    return {};
}

/// Does what a key or button does once. What is refused has changed nothing.
Outcome press(State& state, const assets::Assets& assets, const Command& command)
{
    const State before = state;
    Outcome outcome = command.press(state, assets);
    if (!outcome.refusal.empty()) {
        state = before;
        return outcome;
    }
    for (const Field& field : fields()) {
        outcome.fields.set(static_cast<std::size_t>(field.id), field.get(before) != field.get(state));
    }
    return outcome;
}

Outcome execute(State& state, const assets::Assets& assets, const Command& command, double value)
{
    Outcome outcome;
    switch (command.kind) {
    case CommandKind::hold: {
        const auto row = static_cast<std::size_t>(&command - commands().data());
        outcome.holds_changed = state.held.test(row) != (value == 1.0);
        state.held.set(row, value == 1.0);
        break;
    }
    case CommandKind::press:
        return value == 1.0 ? press(state, assets, command) : outcome;
    case CommandKind::add:
        for (const Move& move : command.moves) {
            add(state, move, value, outcome.fields);
        }
        break;
    case CommandKind::set:
        for (const Move& move : command.moves) {
            const Field& target = field(move.field);
            const double old = target.get(state);
            set_grid_value(target, state, to_grid_from_unit(target, value));
            outcome.fields.set(static_cast<std::size_t>(target.id), target.get(state) != old);
        }
        break;
    }
    return outcome;
}

} // namespace

Outcome apply(State& state, const assets::Assets& assets, const Command& command, double value)
{
    if (std::string fault = faulty_value(command, value); !fault.empty()) {
        return Outcome::refused(std::move(fault));
    }
    Outcome outcome = execute(state, assets, command, value);
    if (!outcome.opened && !outcome.fired) {
        end_event_if_changed(state, outcome);
    }
    return outcome;
}

Outcome apply(State& state, const assets::Assets& assets, std::string_view name, double value)
{
    const Command* command = find_command(name);
    if (command == nullptr) {
        return Outcome::refused("There is no command " + base::in_quotes(name) + ".");
    }
    return apply(state, assets, *command, value);
}

Outcome step(State& state, const assets::Assets& assets)
{
    // Summed first, so that opposite holds cancel exactly and a limit is applied to the sum.
    FieldRates rates{};
    FieldRates growths{};
    double forward = 0.0;
    const std::span<const Command> all = commands();
    for (std::size_t i = 0; i < state.held.size() && i < all.size(); ++i) {
        if (!state.held[i]) {
            continue;
        }
        for (const Move& move : all[i].moves) {
            if (move.along_heading) {
                forward += move.field == FieldId::z ? move.rate : 0.0; // x goes along
                continue;
            }
            const auto [moved, factor] = moved_by(state, move);
            (move.relative ? growths : rates)[static_cast<std::size_t>(moved.id)] += move.rate * factor;
        }
    }
    if (forward != 0.0 || rates[static_cast<std::size_t>(FieldId::heading)] != 0.0) {
        add_driving(rates, state, assets, forward);
    }
    const double heading = state.joints[tank::Joint::heading];
    Outcome outcome;
    for (const Field& field : fields()) {
        const double rate = rates[static_cast<std::size_t>(field.id)];
        const double growth = growths[static_cast<std::size_t>(field.id)];
        if (rate == 0.0 && growth == 0.0) {
            continue;
        }
        const double old = field.get(state);
        const double moved = grown(old + rate / TICKS_PER_SECOND, growth / TICKS_PER_SECOND);
        change(state, field, within_limits(field, moved), outcome.fields);
    }
    end_event_if_changed(state, outcome);
    if (rates[static_cast<std::size_t>(FieldId::chase)] == 0.0) {
        swing_behind(state, heading, outcome.fields);
    }
    const bool flew = state.shot.flies;
    outcome.event_changed |= step_event(state);
    outcome.landed = flew && !state.shot.flies;
    ++state.tick;
    return outcome;
}

} // namespace app
