#include "app/commands/commands.h"
#include "app/commands/update.h"
#include "checks/check_text.h"
#include "checks/lab_1_checks.h"
#include "tank/joint.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace checks {
namespace {

using tank::Joint;
using tank::Part;

/// What the lab wants to be turned, and what shall move then. Written here once more, so that a fault in
/// the tables of parts and commands is found.
struct Turning
{
    std::string_view name;
    app::FieldId field;
    Joint joint;
    bool (*moves)(Part part);
};

constexpr Turning TURNINGS[] = {
    {"turret", app::FieldId::turret, Joint::turret,
     [](Part part) { return part == Part::turret || part == Part::main_gun || part == Part::secondary_gun; }},
    {"main gun", app::FieldId::main_gun, Joint::main_gun, [](Part part) { return part == Part::main_gun; }},
    {"secondary gun", app::FieldId::secondary_gun, Joint::secondary_gun,
     [](Part part) { return part == Part::secondary_gun; }},
    {"secondary gun's cradle", app::FieldId::secondary_gun_pitch, Joint::secondary_gun_pitch,
     [](Part part) { return part == Part::secondary_gun; }},
    {"wheels", app::FieldId::wheels_left, Joint::wheels_left,
     [](Part part) { return part >= Part::wheel_left_1; }},
};

/// Returns the command with a key that turns the field one way (sign +1 or -1) while it is held, or null.
const app::Command* key_command(app::FieldId field, double sign)
{
    for (const app::Command& command : app::commands()) {
        if (command.kind != app::CommandKind::hold || command.keys[0] == app::Key::none) {
            continue;
        }
        for (const app::Move& move : command.moves) {
            if (move.field == field && move.rate * sign > 0.0) {
                return app::command_for_key(command.keys[0]);
            }
        }
    }
    return nullptr;
}

void hold(const CheckSubject& subject, app::State& state, const app::Command& command, int ticks)
{
    app::apply(state, subject.assets, command, 1.0);
    for (int tick = 0; tick < ticks; ++tick) {
        app::step(state, subject.assets);
    }
    app::apply(state, subject.assets, command, 0.0);
}

/// Tells whether the angle went the way of `sign`; round the back counts as the short way.
bool turned_towards(double from, double to, double sign)
{
    return std::sin(to - from) * sign > 0.0;
}

/// Returns the parts that are not drawn where the state says; for a state before, those that have moved.
PartSet not_drawn_at(const CheckSubject& subject, const FrameCapture& capture, const app::State& state)
{
    const PartCalls calls = find_part_calls(subject, capture, state);
    PartSet parts;
    for (Part part : tank::ALL_PARTS) {
        parts[tank::index_of(part)] = !calls[tank::index_of(part)].has_value();
    }
    return parts;
}

void check_key(const CheckSubject& subject, const Turning& turning, double sign, Evidence& evidence)
{
    const std::string way = sign > 0.0 ? "one way" : "the other way";
    const app::Command* command = key_command(turning.field, sign);
    if (command == nullptr) {
        evidence.require(false, "", "No key turns the " + std::string(turning.name) + " " + way + ".");
        return;
    }
    const std::string key = "Key " + std::string(app::key_label(command->keys[0]));
    const app::State before;
    app::State after = before;
    constexpr int TICKS = 20; // a third of a second: no joint reaches its limit, no wheel looks as before
    hold(subject, after, *command, TICKS);

    app::State later = after;
    for (int tick = 0; tick < TICKS; ++tick) {
        app::step(later, subject.assets);
    }
    const bool turned = turned_towards(before.joints[turning.joint], after.joints[turning.joint], sign);
    const bool stays = later.joints == after.joints;
    const FrameCapture capture = capture_frame(subject, after);
    const PartSet wrong = not_drawn_at(subject, capture, after);
    const PartSet moved = not_drawn_at(subject, capture, before);
    PartSet wanted;
    for (Part part : tank::ALL_PARTS) {
        wanted[tank::index_of(part)] = turning.moves(part);
    }
    evidence.require(turned && stays && wrong.none() && moved == wanted,
                     key + " turns the " + std::string(turning.name) + " " + way +
                         " about its own axis, as long as it is held.",
                     key +
                         (turned ? "" : " does not turn the " + std::string(turning.name) + " " + way + ";") +
                         (stays ? "" : " goes on after it is let go;") + " moves " + named(moved) +
                         "; not drawn where they should be: " + named(wrong) + ".");
}

void check_limits(const CheckSubject& subject, const Turning& turning, double sign, Evidence& evidence)
{
    const app::Command* command = key_command(turning.field, sign);
    if (command == nullptr) {
        return; // said already, and failed
    }
    const tank::JointLimits limits = tank::joint_limits(turning.joint);
    const std::string name(turning.name);
    constexpr int TICKS = 30 * app::TICKS_PER_SECOND;
    app::State state;
    if (limits.wraps) {
        double turned = 0.0; // in all, radians
        bool never_stops = true;
        for (int tick = 0; tick < TICKS; ++tick) {
            const double from = state.joints[turning.joint];
            hold(subject, state, *command, 1);
            never_stops = never_stops && turned_towards(from, state.joints[turning.joint], sign);
            turned += std::asin(std::sin(state.joints[turning.joint] - from));
        }
        constexpr double FULL_TURN = 6.283185307179586;
        evidence.require(never_stops && std::fabs(turned) > FULL_TURN,
                         "The " + name + " can be turned all the way round.",
                         "The " + name + " cannot be turned all the way round.");
        return;
    }
    hold(subject, state, *command, TICKS);
    const double limit = sign > 0.0 ? limits.maximum : limits.minimum;
    const FrameCapture capture = capture_frame(subject, state);
    const PartSet wrong = not_drawn_at(subject, capture, state);
    const std::string end = sign > 0.0 ? "upper" : "lower";
    evidence.require(state.joints[turning.joint] == limit && wrong.none(),
                     "The " + name + " stops at the " + end + " end of its range.",
                     "The " + name + " is not held at the " + end + " end of its range, or not drawn there.");
}

} // namespace

void check_joints(const CheckSubject& subject, Evidence& evidence)
{
    for (const Turning& turning : TURNINGS) {
        for (double sign : {+1.0, -1.0}) {
            check_key(subject, turning, sign, evidence);
            check_limits(subject, turning, sign, evidence);
        }
    }
}

} // namespace checks
