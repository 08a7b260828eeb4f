#include "app/commands.h"

#include "app/links.h"

#include <numbers>
#include <vector>

namespace app {

namespace {

using enum FieldId;

constexpr double degrees(double value)
{
    return value * std::numbers::pi / 180.0;
}

using Keys = std::array<Key, 3>;

constexpr Command hold(std::string_view name, std::string_view title, Group group, Keys keys, Move first)
{
    return {.name = name,
            .title = title,
            .group = group,
            .kind = CommandKind::hold,
            .keys = keys,
            .moves = {first},
            .move_count = 1};
}

constexpr Command hold(std::string_view name, std::string_view title, Group group, Keys keys, Move first,
                       Move second)
{
    return {.name = name,
            .title = title,
            .group = group,
            .kind = CommandKind::hold,
            .keys = keys,
            .moves = {first, second},
            .move_count = 2};
}

constexpr Command add(std::string_view name, std::string_view title, Group group, Move move)
{
    return {.name = name,
            .title = title,
            .group = group,
            .kind = CommandKind::add,
            .moves = {move},
            .move_count = 1};
}

constexpr Command press(std::string_view name, std::string_view title, Group group, Keys keys,
                        void (*action)(State&))
{
    return {.name = name,
            .title = title,
            .group = group,
            .kind = CommandKind::press,
            .keys = keys,
            .press = action};
}

/// Gives the fields of the camera, or all others, the values that the state's task began with.
void reset_fields(State& state, bool of_camera)
{
    const State start = starting_state(state.task);
    for (const Field& field : fields()) {
        if ((field.group == Group::camera) == of_camera) {
            field.set(state, field.get(start));
        }
    }
}

void reset_view(State& state)
{
    reset_fields(state, true);
}
void reset_pose(State& state)
{
    reset_fields(state, false);
}
void toggle_ground(State& state)
{
    state.ground = !state.ground;
}
void release_all(State& state)
{
    state.held.reset();
}

// Real vehicles: turrets turn by 40 degrees a second and more, guns rise by 10 or so; the wheels' rate is a
// walking pace of 1.4 m/s. W, S are left for driving, I J K L U O for the projectile, the digits for tasks.
constexpr Command OWN_COMMANDS[] = {
    hold("turret_left", "Turn the turret left", Group::turret, {Key::q}, {turret, degrees(40.0)}),
    hold("turret_right", "Turn the turret right", Group::turret, {Key::e}, {turret, degrees(-40.0)}),
    hold("gun_up", "Raise the main gun", Group::main_gun, {Key::r}, {main_gun, degrees(12.0)}),
    hold("gun_down", "Lower the main gun", Group::main_gun, {Key::f}, {main_gun, degrees(-12.0)}),
    hold("secondary_gun_left", "Turn the secondary gun left", Group::secondary_gun, {Key::t},
         {secondary_gun, degrees(60.0)}),
    hold("secondary_gun_right", "Turn the secondary gun right", Group::secondary_gun, {Key::g},
         {secondary_gun, degrees(-60.0)}),
    hold("wheels_forward", "Roll the wheels forward", Group::wheels, {Key::c}, {wheels_left, degrees(180.0)},
         {wheels_right, degrees(180.0)}),
    hold("wheels_backward", "Roll the wheels backward", Group::wheels, {Key::v},
         {wheels_left, degrees(-180.0)}, {wheels_right, degrees(-180.0)}),
    hold("turn_left", "Turn the tank left", Group::tank, {Key::a}, {heading, degrees(30.0)}),
    hold("turn_right", "Turn the tank right", Group::tank, {Key::d}, {heading, degrees(-30.0)}),
    press("reset_pose", "Bring the tank back to its first pose", Group::tank, {Key::backspace}, reset_pose),
    hold("orbit_left", "Go round to the left", Group::camera, {Key::left}, {orbit, degrees(-60.0)}),
    hold("orbit_right", "Go round to the right", Group::camera, {Key::right}, {orbit, degrees(60.0)}),
    hold("tilt_up", "Go up", Group::camera, {Key::up}, {tilt, degrees(40.0)}),
    hold("tilt_down", "Go down", Group::camera, {Key::down}, {tilt, degrees(-40.0)}),
    hold("zoom_in", "Go nearer", Group::camera, {Key::page_up, Key::equal, Key::keypad_plus},
         {.field = distance, .rate = -1.2, .relative = true}),
    hold("zoom_out", "Go further away", Group::camera, {Key::page_down, Key::minus, Key::keypad_minus},
         {.field = distance, .rate = 1.2, .relative = true}),
    press("reset_view", "Bring the camera back to its first place", Group::camera, {Key::home}, reset_view),
    press("toggle_ground", "Show or hide the ground", Group::camera, {Key::b}, toggle_ground),
    add("orbit_by", "Go round by an angle", Group::camera, {orbit, degrees(1.0)}),
    add("tilt_by", "Go up by an angle", Group::camera, {tilt, degrees(1.0)}),
    add("zoom_by", "Go nearer by steps", Group::camera, {.field = distance, .rate = -0.1, .relative = true}),
    press("release_all", "Let go of everything held", Group::program, {}, release_all),
};

static_assert(std::size(OWN_COMMANDS) <= MAXIMUM_HELD_COMMANDS);

std::vector<Command> make_commands()
{
    std::vector<Command> commands(std::begin(OWN_COMMANDS), std::end(OWN_COMMANDS));
    for (const Field& field : fields()) {
        commands.push_back({.name = field.name,
                            .title = field.title,
                            .group = field.group,
                            .kind = CommandKind::set,
                            .moves = {Move{field.id}},
                            .move_count = 1});
    }
    for (const FieldAlias& alias : field_aliases()) {
        commands.push_back({.name = alias.name,
                            .title = alias.title,
                            .group = field(alias.fields[0]).group,
                            .kind = CommandKind::set,
                            .moves = {Move{alias.fields[0]}, Move{alias.fields[1]}},
                            .move_count = alias.fields.size()});
    }
    return commands;
}

} // namespace

std::span<const Command> commands()
{
    static const std::vector<Command> COMMANDS = make_commands();
    return COMMANDS;
}

const Command* find_command(std::string_view name)
{
    for (const Command& command : commands()) {
        if (command.name == name) {
            return &command;
        }
    }
    return nullptr;
}

const Command* command_for_key(Key key)
{
    for (const Command& command : commands()) {
        for (Key own : command.keys) {
            if (own != Key::none && own == key) {
                return &command;
            }
        }
    }
    return nullptr;
}

} // namespace app
