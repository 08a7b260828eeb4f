#pragma once

#include "app/simulation/simulation.h"
#include "app/state/state.h"
#include "assets/assets.h"

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

/// Returns what a page is told after every change people can see, as JSON: what something shows at all times,
/// and what tells whether more has to be asked for. `revision`; `level` and `detail`; `triangles` (drawn);
/// `sparks` (alight); `flies` (the projectile is in flight); `view`; `probe`; `held`, `task` and `figure` as
/// in state_json(); `tank` and `has_own_tank`; `printed` (how many reports and events so far).
std::string status_json(const Simulation& simulation);

/// Returns the report of hits alone, as hits_json() has it.
std::string report_json(const Simulation& simulation);

/// Returns the fields as state_json() has them, and nothing else.
std::string fields_json(const State& state);

/// Returns what shows that the state's task is done: `evidence` and `moving` as in state_json(), and the
/// field `axis`.
std::string evidence_json(const Simulation& simulation);

} // namespace app
