#include "app/commands/commands.h"

#include "app/commands/firing.h"
#include "app/commands/pointer.h"
#include "app/links/links.h"
#include "app/links/tasks.h"

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
            .moves = {first}};
}

constexpr Command hold(std::string_view name, std::string_view title, Group group, Keys keys, Move first,
                       Move second)
{
    return {.name = name,
            .title = title,
            .group = group,
            .kind = CommandKind::hold,
            .keys = keys,
            .moves = {first, second}};
}

constexpr Command drive(std::string_view name, std::string_view title, Keys keys, double speed)
{
    return hold(name, title, Group::tank, keys, {.field = x, .rate = speed, .along_heading = true},
                {.field = z, .rate = speed, .along_heading = true});
}

constexpr Command add(std::string_view name, std::string_view title, Group group, Move move)
{
    return {.name = name, .title = title, .group = group, .kind = CommandKind::add, .moves = {move}};
}

constexpr Command press(std::string_view name, std::string_view title, Group group, Keys keys,
                        Outcome (*action)(State&, const assets::Assets&))
{
    return {.name = name,
            .title = title,
            .group = group,
            .kind = CommandKind::press,
            .keys = keys,
            .press = action};
}

/// Gives the fields of some groups the values that the state's task began with.
template <class Chosen> void reset_fields(State& state, Chosen chosen)
{
    const State start = starting_state(state.task);
    for (const Field& field : fields()) {
        if (chosen(field.group)) {
            field.set(state, field.get(start));
        }
    }
}

Outcome reset_view(State& state, const assets::Assets&)
{
    reset_fields(state, [](Group group) { return group == Group::camera; });
    return {};
}

Outcome reset_pose(State& state, const assets::Assets&)
{
    reset_fields(state, [](Group group) { return group <= Group::tank; });
    return {};
}

Outcome reset_projectile(State& state, const assets::Assets&)
{
    reset_fields(state, [](Group group) { return group == Group::projectile; });
    const bool flew = state.shot.flies;
    const bool was_under_way = flew || state.event.kind != EventKind::none;
    state.shot = {};
    state.event = {};
    return {.event_changed = was_under_way, .landed = flew};
}

Outcome release_all(State& state, const assets::Assets&)
{
    const bool held = state.held.any();
    state.held.reset();
    return {.holds_changed = held};
}

/// Goes to the next choice of a field, from the last to the first.
template <FieldId id> Outcome next(State& state, const assets::Assets&)
{
    const Field& chosen = field(id);
    const auto count = static_cast<std::int64_t>(chosen.choices.size());
    set_grid_value(chosen, state, (grid_value(chosen, state) + 1) % count);
    return {};
}

/// Makes the distance the threshold.
Outcome note_threshold(State& state, const assets::Assets&)
{
    const Field& threshold_field = field(threshold);
    set_grid_value(threshold_field, state, to_grid(threshold_field, state.camera.distance));
    return {};
}

Outcome print_report(State&, const assets::Assets&)
{
    return {.printed = true};
}

/// Opens the next of the tasks whose id begins with `section`, or of the figures, from the last to the first.
template <TaskKind kind, char section> Outcome open_next(State& state, const assets::Assets&)
{
    const std::span<const Task> all = tasks();
    const std::size_t current = state.task.value_or(all.size() - 1);
    for (std::size_t i = 1; i <= all.size(); ++i) {
        const std::size_t row = (current + i) % all.size();
        if (all[row].kind == kind && (kind == TaskKind::figure || all[row].id[0] == section)) {
            state = starting_state(row);
            return {.opened = true};
        }
    }
    return Outcome::refused("The lab has no such task.");
}

constexpr Move of_handle(FieldId field, double rate)
{
    return {.field = field, .rate = rate, .of_handle = true};
}

// Real vehicles: turrets turn by 40 degrees a second and more, guns rise by 10 or so, and one on a pintle is
// swung by hand; the wheels' rate is a walking pace of 1.4 m/s. Off the road they drive at 18 km/h; turning
// in place takes 12 seconds a round. The digits 1 to 4 open tasks and figures.
constexpr Command OWN_COMMANDS[] = {
    hold("turret_left", "Turn the turret left", Group::joints, {Key::q}, {turret, degrees(40.0)}),
    hold("turret_right", "Turn the turret right", Group::joints, {Key::e}, {turret, degrees(-40.0)}),
    hold("gun_up", "Raise the main gun", Group::joints, {Key::r}, {main_gun, degrees(12.0)}),
    hold("gun_down", "Lower the main gun", Group::joints, {Key::f}, {main_gun, degrees(-12.0)}),
    hold("secondary_gun_left", "Turn the secondary gun left", Group::joints, {Key::t},
         {secondary_gun, degrees(60.0)}),
    hold("secondary_gun_right", "Turn the secondary gun right", Group::joints, {Key::g},
         {secondary_gun, degrees(-60.0)}),
    hold("secondary_gun_up", "Raise the secondary gun", Group::joints, {Key::period},
         {secondary_gun_pitch, degrees(40.0)}),
    hold("secondary_gun_down", "Lower the secondary gun", Group::joints, {Key::comma},
         {secondary_gun_pitch, degrees(-40.0)}),
    hold("wheels_forward", "Roll the wheels forward", Group::joints, {Key::c}, {wheels_left, degrees(180.0)},
         {wheels_right, degrees(180.0)}),
    hold("wheels_backward", "Roll the wheels backward", Group::joints, {Key::v},
         {wheels_left, degrees(-180.0)}, {wheels_right, degrees(-180.0)}),
    drive("drive_forward", "Drive forward", {Key::w}, 5.0),
    drive("drive_backward", "Drive backward", {Key::s}, -5.0),
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
    press("next_view", "Look from around, from behind, through the gunner's sight, or from four sides",
          Group::camera, {Key::end}, next<view>),
    press("toggle_ground", "Show or hide the ground", Group::camera, {Key::b}, next<ground>),
    hold("projectile_right", "Move the projectile along +X", Group::projectile, {Key::l},
         of_handle(point_x, 2.0)),
    hold("projectile_left", "Move the projectile along -X", Group::projectile, {Key::j},
         of_handle(point_x, -2.0)),
    hold("projectile_up", "Raise the projectile", Group::projectile, {Key::o}, of_handle(point_y, 2.0)),
    hold("projectile_down", "Lower the projectile", Group::projectile, {Key::u}, of_handle(point_y, -2.0)),
    hold("projectile_away", "Move the projectile along -Z", Group::projectile, {Key::i},
         of_handle(point_z, -2.0)),
    hold("projectile_nearer", "Move the projectile along +Z", Group::projectile, {Key::k},
         of_handle(point_z, 2.0)),
    press("next_handle", "Move the point, or the line's end A or B", Group::projectile, {Key::m},
          next<handle>),
    press("next_probe", "Test nothing, the point, or a segment, ray or line from A to B", Group::projectile,
          {Key::y}, next<probe>),
    press("fire", "Fire the projectile along its line", Group::projectile, {Key::space}, fire),
    press("fire_at_aim", "Fire the projectile from the eye through the aim", Group::projectile, {Key::enter},
          fire_at_aim),
    press("move_to_aim", "Move the projectile to where the aim points at", Group::projectile, {},
          move_to_aim),
    press("reset_projectile", "Bring the projectile and its line back to their first place",
          Group::projectile, {Key::delete_forward}, reset_projectile),
    press("next_spheres", "Show no spheres, penetrated ones, the whole tank's, the parts', or all",
          Group::spheres, {Key::h}, next<spheres>),
    press("next_fit", "Compute the spheres the lab's way or as the smallest", Group::spheres, {Key::digit_9},
          next<fit>),
    press("toggle_triangles", "Test what is inside a part's sphere against its triangles", Group::spheres,
          {Key::digit_8}, next<triangles>),
    press("print_report", "Print what is penetrated", Group::spheres, {Key::p}, print_report),
    press("next_particles", "Show the next particle system", Group::particles, {Key::digit_5},
          next<particles>),
    press("next_detail", "Draw the model by distance, the high, the low, or both", Group::detail, {Key::x},
          next<detail>),
    press("note_threshold", "Make this distance the threshold", Group::detail, {Key::n}, note_threshold),
    press("next_parts", "Draw all parts or only some", Group::picture, {Key::digit_6}, next<parts>),
    press("next_axis", "Draw the axis of the next part", Group::picture, {Key::digit_7}, next<axis>),
    press("toggle_wireframe", "Draw edges or faces", Group::picture, {Key::z}, next<wireframe>),
    press("next_tank", "Show Tank Lab's tank or your own", Group::picture, {Key::digit_0}, next<tank>),
    press("next_task_1", "Open the next task of section 1", Group::program, {Key::digit_1},
          open_next<TaskKind::task, '1'>),
    press("next_task_2", "Open the next task of section 2", Group::program, {Key::digit_2},
          open_next<TaskKind::task, '2'>),
    press("next_task_3", "Open the next task of section 3", Group::program, {Key::digit_3},
          open_next<TaskKind::task, '3'>),
    press("next_figure", "Open the next figure of the handout", Group::program, {Key::digit_4},
          open_next<TaskKind::figure, ' '>),
    add("projectile_x_by", "Move the projectile along X", Group::projectile, of_handle(point_x, 1.0)),
    add("projectile_y_by", "Raise the projectile", Group::projectile, of_handle(point_y, 1.0)),
    add("projectile_z_by", "Move the projectile along Z", Group::projectile, of_handle(point_z, 1.0)),
    add("orbit_by", "Go round by an angle", Group::camera, {orbit, degrees(1.0)}),
    add("tilt_by", "Go up by an angle", Group::camera, {tilt, degrees(1.0)}),
    add("zoom_by", "Go nearer by steps", Group::camera, {.field = distance, .rate = -0.1, .relative = true}),
    press("release_all", "Let go of everything held", Group::program, {}, release_all),
};

static_assert(std::size(OWN_COMMANDS) <= MAX_HELD_COMMANDS);

std::vector<Command> make_commands()
{
    std::vector<Command> commands(std::begin(OWN_COMMANDS), std::end(OWN_COMMANDS));
    for (const Field& field : fields()) {
        commands.push_back({.name = field.name,
                            .title = field.title,
                            .group = field.group,
                            .kind = CommandKind::set,
                            .moves = {Move{field.id}}});
    }
    for (const FieldAlias& alias : field_aliases()) {
        commands.push_back({.name = alias.name,
                            .title = alias.title,
                            .group = field(alias.fields[0]).group,
                            .kind = CommandKind::set,
                            .moves = {Move{alias.fields[0]}, Move{alias.fields[1]}}});
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
