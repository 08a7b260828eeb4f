#include "app/links/links.h"

#include "app/links/link_items.h"
#include "app/links/tasks.h"
#include "app/state/fields.h"
#include "app/state/flight.h"
#include "base/decimal.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <span>

namespace app {

namespace {

std::optional<TaskKind> task_kind(std::string_view key)
{
    for (TaskKind kind : {TaskKind::task, TaskKind::figure}) {
        if (key == link_key(kind)) {
            return kind;
        }
    }
    return std::nullopt;
}

const FieldAlias* find_alias(std::string_view name)
{
    for (const FieldAlias& alias : field_aliases()) {
        if (alias.name == name) {
            return &alias;
        }
    }
    return nullptr;
}

/// Sets the fields that a key names; says so if there is no such key.
void use_item(const Item& item, State& state, Messages& messages)
{
    if (const Field* field = find_field(item.key)) {
        if (const std::optional<std::int64_t> value = read_value(*field, item, messages)) {
            set_grid_value(*field, state, *value);
        }
    } else if (const FieldAlias* alias = find_alias(item.key)) {
        for (FieldId id : alias->fields) {
            if (const std::optional<std::int64_t> value = read_value(app::field(id), item, messages)) {
                set_grid_value(app::field(id), state, *value);
            }
        }
    } else {
        messages.add(base::in_quotes(item.key) + " is not something a link can set and is ignored.");
    }
}

/// What a link says about the event to be replayed, as three values that are written where they differ from
/// those of the task. Without an event all are as here.
struct Replay
{
    EventKind kind = EventKind::none;
    std::int64_t tick = 0;
    std::int64_t seed = FIRST_SEED;
};

constexpr std::array<std::string_view, 3> EVENT_NAMES = {
    event_name(EventKind::none), event_name(EventKind::open), event_name(EventKind::fire)};

bool is_replay_key(std::string_view key)
{
    return key == "event" || key == "tick" || key == "seed";
}

Replay replay_of(const State& state)
{
    if (state.event.kind == EventKind::none) {
        return {};
    }
    return {state.event.kind, state.event.age, static_cast<std::int64_t>(state.seed)};
}

/// Returns the replay that the items ask for, where they do not say otherwise that of the task.
Replay read_replay(std::span<const Item> items, Replay replay, Messages& messages)
{
    bool is_asked = false;
    bool has_kind = replay.kind != EventKind::none;
    for (const Item& item : items) {
        if (item.key == "event") {
            const auto found =
                std::find(EVENT_NAMES.begin(), EVENT_NAMES.end(), base::lower_case(item.value));
            if (found == EVENT_NAMES.end()) {
                messages.add("event=" + base::in_quotes(item.value) + " is not one of " +
                             base::listed(EVENT_NAMES, "or") + " and is ignored.");
                continue;
            }
            replay.kind = static_cast<EventKind>(found - EVENT_NAMES.begin());
            has_kind = true;
        } else if (item.key == "tick") {
            if (const auto tick = read_count(item, 0, MAX_REPLAY_TICKS, messages)) {
                replay.tick = *tick;
                is_asked = true;
            }
        } else if (item.key == "seed") {
            if (const auto seed = read_count(item, FIRST_SEED, LAST_SEED, messages)) {
                replay.seed = *seed;
                is_asked = true;
            }
        }
    }
    if (is_asked && !has_kind) {
        replay.kind = EventKind::open;
    }
    return replay.kind == EventKind::none ? Replay{} : replay;
}

/// Lets the event happen in the state, so many ticks ago.
void use_replay(const Replay& replay, State& state, Messages& messages)
{
    state.seed = static_cast<std::uint64_t>(replay.seed);
    if (std::string fault = begin_event(state, replay.kind, static_cast<std::uint32_t>(replay.tick));
        !fault.empty()) {
        messages.add(std::move(fault));
    }
    if (state.event.kind == EventKind::none) {
        state.seed = FIRST_SEED;
    }
    state.tick = state.event.age;
}

/// Returns the state that the items describe: the task's, changed by the others.
State read_state(std::span<const Item> items, std::optional<std::size_t> task, Messages& messages)
{
    State state = starting_state(task);
    const Replay of_task = replay_of(state);
    begin_event(state, EventKind::none, 0);
    for (const Item& item : items) {
        if (!task_kind(item.key) && !is_replay_key(item.key)) {
            use_item(item, state, messages);
        }
    }
    state.task = task;
    use_replay(read_replay(items, of_task, messages), state, messages);
    return state;
}

/// Returns the task or figure that the items name last, if any.
std::optional<std::size_t> read_task(std::span<const Item> items, Messages& messages)
{
    std::optional<std::size_t> task;
    for (const Item& item : items) {
        const std::optional<TaskKind> kind = task_kind(item.key);
        if (!kind) {
            continue;
        }
        const std::optional<std::size_t> found = find_task(*kind, base::lower_case(item.value));
        if (!found) {
            messages.add("There is no " + item.key + " " + base::in_quotes(item.value) + "; it is ignored.");
            continue;
        }
        if (task && tasks()[*task].kind != *kind) {
            messages.add("The link names a task and a figure; the last one is used.");
        }
        task = found;
    }
    return task;
}

void append_item(std::string& link, std::string_view key, std::string_view value)
{
    if (!link.empty()) {
        link += '&';
    }
    link += key;
    link += '=';
    link += value;
}

std::string written_value(const Field& field, std::int64_t value)
{
    return field.choices.empty() ? base::write_decimal(value, field.unit.decimals)
                                 : std::string(field.choices[static_cast<std::size_t>(value)]);
}

} // namespace

State starting_state(std::optional<std::size_t> task)
{
    if (!task) {
        return {};
    }
    Messages none; // a test holds the table's links free of faults
    const std::vector<Item> items = read_items(tasks()[*task].link, none);
    State state = read_state(items, std::nullopt, none);
    state.task = task;
    return state;
}

std::string link(const State& state)
{
    const State start = starting_state(state.task);
    std::string result;
    if (state.task) {
        const Task& task = tasks()[*state.task];
        append_item(result, link_key(task.kind), task.id);
    }
    for (const Field& field : fields()) {
        const std::int64_t value = grid_value(field, state);
        if (value != grid_value(field, start)) {
            append_item(result, field.name, written_value(field, value));
        }
    }
    const Replay replay = replay_of(state);
    const Replay of_start = replay_of(start);
    if (replay.kind != of_start.kind) {
        append_item(result, "event", EVENT_NAMES[static_cast<std::size_t>(replay.kind)]);
    }
    if (replay.kind != EventKind::none) {
        if (replay.tick != of_start.tick) {
            append_item(result, "tick", base::write_decimal(replay.tick, 0));
        }
        if (replay.seed != of_start.seed) {
            append_item(result, "seed", base::write_decimal(replay.seed, 0));
        }
    }
    return result;
}

State snapped(const State& state)
{
    State result;
    result.task = state.task;
    for (const Field& field : fields()) {
        set_grid_value(field, result, grid_value(field, state));
    }
    if (state.event.kind != EventKind::none) {
        result.seed = state.seed;
        result.event = state.event;
        result.shot = state.shot;
        result.tick = state.event.age;
    }
    return result;
}

LinkResult open_link(State& state, std::string_view fragment)
{
    Messages messages;
    if (fragment.size() > MAX_LINK_BYTES) {
        messages.add("The link is longer than " + base::write_decimal(MAX_LINK_BYTES, 0) +
                     " characters and is not used.");
        return {.messages = messages.take(), .outcome = {}};
    }
    if (!fragment.empty() && fragment[0] == '#') {
        fragment.remove_prefix(1);
    }
    const std::vector<Item> items = read_items(fragment, messages);
    report_duplicates(items, messages);
    state = read_state(items, read_task(items, messages), messages);
    return {.messages = messages.take(), .outcome = {.opened = true}};
}

} // namespace app
