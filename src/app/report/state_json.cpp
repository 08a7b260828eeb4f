#include "app/report/state_json.h"

#include "app/commands/commands.h"
#include "app/links/links.h"
#include "app/links/tasks.h"
#include "app/report/facts.h"
#include "app/state/fields.h"
#include "app/state/flight.h"
#include "app/view/frame.h"
#include "base/json_writer.h"
#include "base/measures.h"

namespace app {

namespace {

void write_field(base::JsonWriter& json, const State& state, const Field& field)
{
    const std::int64_t value = grid_value(field, state);
    json.key(field.name);
    if (field.choices.empty()) {
        json.decimal(value, field.unit.decimals);
    } else {
        json.string(field.choices[static_cast<std::size_t>(value)]);
    }
}

void write_fields(base::JsonWriter& json, const State& state)
{
    for (const Field& field : fields()) {
        write_field(json, state, field);
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

void write_task_ids(base::JsonWriter& json, const State& state)
{
    write_task_id(json, state, TaskKind::task);
    write_task_id(json, state, TaskKind::figure);
}

void write_held(base::JsonWriter& json, const State& state)
{
    json.key("held").begin_array();
    const std::span<const Command> all = commands();
    for (std::size_t i = 0; i < all.size() && i < state.held.size(); ++i) {
        if (state.held[i]) {
            json.string(all[i].name);
        }
    }
    json.end_array();
}

std::uint64_t sparks_alight(const Simulation& simulation)
{
    std::uint64_t alight = 0;
    for (const particles::ParticleSystem* system : simulation.sparks().systems()) {
        alight += system->live();
    }
    return alight;
}

void write_state(base::JsonWriter& json, const State& state, std::uint64_t revision)
{
    write_fields(json, state);
    json.key("tick").number(state.tick);
    json.key("revision").number(revision);
    json.key("link").string(link(state));
    write_held(json, state);
    write_task_ids(json, state);
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
    json.key("sparks").number(sparks_alight(simulation));
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

void write_evidence(base::JsonWriter& json, const Simulation& simulation)
{
    json.key("moving");
    write_parts(json, simulation.moving_parts());
    json.key("evidence").begin_array();
    for (const Fact& fact : facts(simulation)) {
        json.begin_object().key("label").string(fact.label).key("value").string(fact.value).end_object();
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
    json.key("level").string(lod::level_name(simulation.shown_level()));
    json.key("has_own_tank").boolean(simulation.has_own_tank());
    json.key("hits").begin_object();
    write_hits(json, simulation);
    json.end_object();
    write_projectile(json, simulation);
    write_evidence(json, simulation);
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

std::string status_json(const Simulation& simulation)
{
    const State& state = simulation.state();
    base::JsonWriter json;
    json.begin_object();
    json.key("revision").number(simulation.revision());
    json.key("level").string(lod::level_name(simulation.shown_level()));
    json.key("triangles").number(std::uint64_t{triangles_drawn(simulation)});
    json.key("sparks").number(sparks_alight(simulation));
    json.key("flies").boolean(state.shot.flies);
    for (FieldId id : {FieldId::detail, FieldId::view, FieldId::probe, FieldId::tank}) {
        write_field(json, state, field(id));
    }
    json.key("has_own_tank").boolean(simulation.has_own_tank());
    write_held(json, state);
    write_task_ids(json, state);
    json.key("printed").number(simulation.log().count());
    json.end_object();
    return json.take();
}

std::string report_json(const Simulation& simulation)
{
    base::JsonWriter json;
    write_report(json, simulation.report());
    return json.take();
}

std::string fields_json(const State& state)
{
    base::JsonWriter json;
    json.begin_object();
    write_fields(json, state);
    json.end_object();
    return json.take();
}

std::string evidence_json(const Simulation& simulation)
{
    base::JsonWriter json;
    json.begin_object();
    write_field(json, simulation.state(), field(FieldId::axis));
    write_evidence(json, simulation);
    json.end_object();
    return json.take();
}

} // namespace app
