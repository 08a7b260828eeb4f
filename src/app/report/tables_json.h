#pragma once

#include "app/links/tasks.h"
#include "base/json_writer.h"

#include <span>
#include <string>
#include <string_view>

namespace app {

/// Returns the table of commands as a JSON array. Every row has `name`, `title`, `group`, `kind`, `keys` (the
/// browser's KeyboardEvent.code) and `key_labels`. Rows that move fields have `fields`, their link names, and
/// `unit`. Rows that set have besides `minimum`, `maximum`, `step`, `default` and `wraps`, or `choices` (the
/// value is an index of them).
std::string commands_json();

/// Writes a row of the table of tasks and figures as members of an object that has begun: `id`, `kind`,
/// `title`, `text`, `commands` (names of commands to try), `link` (opens it, such as "task=1.2"), `source`.
void write_task(base::JsonWriter& json, const Task& task);

/// Returns texts as a JSON array of strings, such as the messages of a link.
std::string strings_json(std::span<const std::string> texts);

/// Returns the files that make a tank as {"meshes": [names, the high ones first], "texture": [names, of which
/// one is enough], "largest_mesh": bytes, "largest_texture": bytes}: longer files are refused when read.
std::string asset_manifest_json();

/// Returns what came of a user's own tank as {"error": sentence or "", "notes": [sentences]}.
std::string tank_brought_json(std::string_view error, std::span<const std::string> notes);

} // namespace app
