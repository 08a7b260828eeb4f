#include "app/report/tables_json.h"

#include "app/commands/commands.h"
#include "app/state/fields.h"
#include "assets/assets.h"
#include "image/image.h"
#include "mesh/obj_reader.h"

namespace app {

namespace {

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
    if (!command.moves.empty()) {
        const Field& first = field(command.moves[0].field);
        json.key("fields").begin_array();
        for (const Move& move : command.moves) {
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

} // namespace

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
    json.key("largest_mesh").number(std::uint64_t{mesh::MAX_OBJ_BYTES});
    json.key("largest_texture").number(std::uint64_t{image::MAX_IMAGE_FILE_BYTES});
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
