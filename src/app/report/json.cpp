#include "app/report/json.h"

#include "app/commands/commands.h"
#include "app/links/links.h"
#include "app/report/facts.h"
#include "app/state/fields.h"
#include "app/state/flight.h"
#include "app/view/frame.h"
#include "base/measures.h"
#include "mesh/obj_reader.h"

namespace app {

namespace {

void write_value(base::JsonWriter& json, const Field& field, std::int64_t value)
{
    if (field.choices.empty()) {
        json.decimal(value, field.unit.decimals);
    } else {
        json.string(field.choices[static_cast<std::size_t>(value)]);
    }
}

void write_task_id(base::JsonWriter& json, const State& state, TaskKind kind)
{
    json.key(link_key(kind));
    if (state.task && tasks()[*state.task].kind == kind) {
        json.string(tasks()[*state.task].id);
    } else {
        json.null();
    }
}

void write_keys(base::JsonWriter& json, const Command& command)
{
    json.key("keys").begin_array();
    for (Key key : command.keys) {
        if (key != Key::none) {
            json.string(key_code(key));
        }
    }
    json.end_array().key("key_labels").begin_array();
    for (Key key : command.keys) {
        if (key != Key::none) {
            json.string(key_label(key));
        }
    }
    json.end_array();
}

/// Writes what a slider or a list of choices needs; the fields of one command have the same range.
void write_range(base::JsonWriter& json, const Field& field)
{
    if (!field.choices.empty()) {
        json.key("choices").begin_array();
        for (std::string_view choice : field.choices) {
            json.string(choice);
        }
        json.end_array();
        json.key("default").number(field.initial);
        return;
    }
    const int decimals = field.unit.decimals;
    json.key("minimum").decimal(grid_minimum(field), decimals);
    json.key("maximum").decimal(grid_maximum(field), decimals);
    json.key("step").decimal(1, decimals);
    json.key("default").decimal(field.initial, decimals);
    json.key("wraps").boolean(field.wraps);
}

constexpr std::string_view kind_name(CommandKind kind)
{
    switch (kind) {
    case CommandKind::hold:
        return "hold";
    case CommandKind::press:
        return "press";
    case CommandKind::add:
        return "add";
    case CommandKind::set:
        return "set";
    }
    return {};
}

void write_command(base::JsonWriter& json, const Command& command)
{
    json.begin_object();
    json.key("name").string(command.name);
    json.key("title").string(command.title);
    json.key("group").string(group_name(command.group));
    json.key("kind").string(kind_name(command.kind));
    write_keys(json, command);
    if (command.move_count > 0) {
        const Field& first = field(command.moves[0].field);
        json.key("fields").begin_array();
        for (const Move& move : command.used_moves()) {
            json.string(field(move.field).name);
        }
        json.end_array();
        // Steps of the wheel have no unit; a fixed amount has its field's.
        json.key("unit").string(command.moves[0].relative ? std::string_view{} : first.unit.name);
        if (command.kind == CommandKind::set) {
            write_range(json, first);
        }
    }
    json.end_object();
}

void write_state(base::JsonWriter& json, const State& state, std::uint64_t revision)
{
    for (const Field& field : fields()) {
        json.key(field.name);
        write_value(json, field, grid_value(field, state));
    }
    json.key("tick").number(state.tick);
    json.key("revision").number(revision);
    json.key("link").string(link(state));
    json.key("held").begin_array();
    const std::span<const Command> all = commands();
    for (std::size_t i = 0; i < all.size() && i < state.held.size(); ++i) {
        if (state.held[i]) {
            json.string(all[i].name);
        }
    }
    json.end_array();
    write_task_id(json, state, TaskKind::task);
    write_task_id(json, state, TaskKind::figure);
}

/// Returns sixteen digits. A number of 64 bits has no place in JavaScript's.
std::string in_hexadecimal(std::uint64_t value)
{
    std::string digits(16, '0');
    for (std::size_t i = digits.size(); i > 0; --i, value >>= 4) {
        digits[i - 1] = "0123456789abcdef"[value & 15];
    }
    return digits;
}

void write_parts(base::JsonWriter& json, collision::PartSet parts)
{
    json.begin_array();
    parts.for_each([&](std::size_t part) { json.string(tank::part_name(static_cast<tank::Part>(part))); });
    json.end_array();
}

void write_projectile(base::JsonWriter& json, const Simulation& simulation)
{
    const State& state = simulation.state();
    json.key("event").string(event_name(state.event.kind));
    json.key("shot");
    if (state.shot.flies) {
        const glm::dvec3 position = position_of(state.shot);
        json.begin_array();
        for (int axis = 0; axis < 3; ++axis) {
            json.decimal(base::to_millimetres(position[axis]), 3);
        }
        json.end_array();
    } else {
        json.null();
    }
    json.key("inside");
    write_parts(json, simulation.inside());
    json.key("touches").number(simulation.touches());
    std::uint64_t alight = 0;
    for (const particles::ParticleSystem* system : simulation.sparks().systems()) {
        alight += system->live();
    }
    json.key("sparks").number(alight);
    json.key("level_switches").number(simulation.level_switches());
    json.key("hash").string(in_hexadecimal(simulation.hash()));
}

void write_hits(base::JsonWriter& json, const Simulation& simulation)
{
    json.key("count").number(simulation.log().count());
    json.key("report");
    write_report(json, simulation.report());
    json.key("lines").begin_array();
    for (const std::string& line : report_lines(simulation.report())) {
        json.string(line);
    }
    json.end_array();
}

} // namespace

std::string state_json(const State& state, const assets::Assets* assets)
{
    base::JsonWriter json;
    json.begin_object();
    write_state(json, state, 0);
    json.key("level");
    if (assets != nullptr) {
        json.string(lod::level_name(make_frame(state, *assets).tanks[0].level));
    } else {
        json.null();
    }
    json.end_object();
    return json.take();
}

std::string state_json(const Simulation& simulation)
{
    base::JsonWriter json;
    json.begin_object();
    write_state(json, simulation.state(), simulation.revision());
    json.key("level").string(lod::level_name(simulation.frame().tanks[0].level));
    json.key("has_own_tank").boolean(simulation.has_own_tank());
    json.key("hits").begin_object();
    write_hits(json, simulation);
    json.end_object();
    write_projectile(json, simulation);
    json.key("moving");
    write_parts(json, simulation.moving_parts());
    json.key("evidence").begin_array();
    for (const Fact& fact : facts(simulation)) {
        json.begin_object().key("label").string(fact.label).key("value").string(fact.value).end_object();
    }
    json.end_array();
    json.end_object();
    return json.take();
}

std::string hits_json(const Simulation& simulation)
{
    base::JsonWriter json;
    json.begin_object();
    write_hits(json, simulation);
    json.key("log").begin_array();
    for (const LogLine& line : simulation.log().lines()) {
        json.begin_object().key("report").number(line.report);
        json.key("text").string(line.text).end_object();
    }
    json.end_array().end_object();
    return json.take();
}

std::string commands_json()
{
    base::JsonWriter json;
    json.begin_array();
    for (const Command& command : commands()) {
        write_command(json, command);
    }
    json.end_array();
    return json.take();
}

void write_task(base::JsonWriter& json, const Task& task)
{
    json.key("id").string(task.id);
    json.key("kind").string(link_key(task.kind));
    json.key("title").string(task.title);
    json.key("text").string(task.text);
    json.key("commands").begin_array();
    for (std::string_view command : task.commands) {
        if (!command.empty()) {
            json.string(command);
        }
    }
    json.end_array();
    json.key("link").string(std::string(link_key(task.kind)) + "=" + std::string(task.id));
    json.key("source").string(task.source);
}

std::string strings_json(std::span<const std::string> texts)
{
    base::JsonWriter json;
    json.begin_array();
    for (const std::string& text : texts) {
        json.string(text);
    }
    json.end_array();
    return json.take();
}

std::string asset_manifest_json()
{
    base::JsonWriter json;
    json.begin_object().key("meshes").begin_array();
    for (const assets::MeshFile& file : assets::mesh_files()) {
        json.string(file.name);
    }
    json.end_array().key("texture").begin_array();
    for (std::string_view name : assets::texture_file_names()) {
        json.string(name);
    }
    json.end_array();
    json.key("largest_mesh").number(std::uint64_t{mesh::max_obj_bytes});
    json.key("largest_texture").number(std::uint64_t{image::max_image_file_bytes});
    json.end_object();
    return json.take();
}

std::string tank_brought_json(std::string_view error, std::span<const std::string> notes)
{
    base::JsonWriter json;
    json.begin_object().key("error").string(error).key("notes").begin_array();
    for (const std::string& note : notes) {
        json.string(note);
    }
    json.end_array().end_object();
    return json.take();
}

} // namespace app
