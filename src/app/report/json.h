#pragma once

#include "app/links/tasks.h"
#include "app/simulation/simulation.h"
#include "app/state/state.h"
#include "assets/assets.h"
#include "base/json_writer.h"

#include <span>
#include <string>

namespace app {

/// Returns the state as a JSON object: every field by its link name, in its unit for people, on the grid
/// (choices as their names); `tick`, `revision`, `link`, `held` (names of commands), `task` and `figure` (ids
/// or null); `level`: "high" or "low", the model that is drawn, or null without assets.
std::string state_json(const State& state, const assets::Assets* assets);

/// Returns the same for a running simulation, and besides: `has_own_tank` (whether the user has brought one,
/// whether or not the state's `tank` asks for it); `hits`, as hits_json() but without its log;
/// `event` (none, open or fire), `shot` (where it is, or null), `inside` (the parts whose spheres the
/// projectile is inside of), `touches`, `sparks` (how many are alight), `level_switches`, `hash`
/// (Simulation::hash() in hexadecimal); and `evidence`,
/// what shows live that the task is done, as {label, value} (see facts()).
std::string state_json(const Simulation& simulation);

/// Returns what the probe hits as {`count`, `report`, `lines`, `log`}. count: of what was printed since the
/// start; report: an object, or null without a probe (see write_report()); lines: the report as sentences;
/// log: the last printed lines, oldest first, as {report, text}.
std::string hits_json(const Simulation& simulation);

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
