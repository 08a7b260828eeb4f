#include "app/links.h"

#include "app/decimal.h"
#include "app/fields.h"
#include "app/firing.h"
#include "app/tasks.h"
#include "app/text.h"

#include <algorithm>
#include <array>
#include <span>

namespace app {

namespace {

constexpr std::size_t MOST_MESSAGES = 10;

struct Item
{
    std::string key; ///< lower case
    std::string value;
};

std::optional<int> hex_digit(char c)
{
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    if (c >= 'A' && c <= 'F') {
        return c - 'A' + 10;
    }
    return std::nullopt;
}

/// Returns the text with every %41 made a byte, or nothing if a '%' has no two digits after it.
std::optional<std::string> percent_decoded(std::string_view text)
{
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded.push_back(text[i]);
            continue;
        }
        if (i + 2 >= text.size()) {
            return std::nullopt;
        }
        const std::optional<int> high = hex_digit(text[i + 1]);
        const std::optional<int> low = hex_digit(text[i + 2]);
        if (!high || !low) {
            return std::nullopt;
        }
        decoded.push_back(static_cast<char>(*high * 16 + *low));
        i += 2;
    }
    return decoded;
}

/// Removes spaces at both ends, and '+', which stands for one in a form and for nothing before a number.
std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" +");
    if (first == text.npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" +") - first + 1);
}

/// Collects messages, each once, and says how many there were beyond the most that people would read.
class Messages
{
public:
    void add(std::string message)
    {
        if (std::find(messages_.begin(), messages_.end(), message) != messages_.end()) {
            return;
        }
        if (messages_.size() < MOST_MESSAGES) {
            messages_.push_back(std::move(message));
        } else {
            ++more_;
        }
    }

    std::vector<std::string> take()
    {
        if (more_ > 0) {
            messages_.push_back("The link has " + write_decimal(more_, 0) + " more faults.");
        }
        return std::move(messages_);
    }

private:
    std::vector<std::string> messages_;
    int more_ = 0;
};

std::vector<Item> read_items(std::string_view fragment, Messages& messages)
{
    std::vector<Item> items;
    while (!fragment.empty()) {
        const std::size_t end = std::min(fragment.find_first_of("&;"), fragment.size());
        const std::string_view text = fragment.substr(0, end);
        fragment.remove_prefix(std::min(end + 1, fragment.size()));
        const std::optional<std::string> decoded = percent_decoded(text);
        if (!decoded) {
            messages.add(in_quotes(text) + " has a % without two hexadecimal digits and is ignored.");
            continue;
        }
        const std::string_view item = *decoded;
        const std::size_t equals = std::min(item.find('='), item.size());
        const std::string_view key = trimmed(item.substr(0, equals));
        const std::string_view value = trimmed(item.substr(std::min(equals + 1, item.size())));
        if (key.empty() && value.empty()) {
            continue;
        }
        items.push_back({lower_case(key), std::string(value)});
    }
    return items;
}

std::string with_unit(const Field& field, std::int64_t value)
{
    std::string text = write_decimal(value, field.unit.decimals);
    if (!field.unit.name.empty()) {
        text += ' ';
        text += field.unit.name;
    }
    return text;
}

/// Says why a value is not a number, as the end of a sentence that begins with the key and the value.
std::string_view reason(DecimalError error)
{
    switch (error) {
    case DecimalError::comma:
        return " has a comma; write a point instead. It is ignored.";
    case DecimalError::exponent:
        return " has an exponent; write the number out. It is ignored.";
    case DecimalError::too_large:
        return " has too many digits and is ignored.";
    default:
        return " is not a number and is ignored.";
    }
}

/// Returns the value on the field's grid, or nothing, having said why. Says so too if it had to be clamped.
std::optional<std::int64_t> read_value(const Field& field, const Item& item, Messages& messages)
{
    if (item.value.empty()) {
        messages.add(in_quotes(item.key) + " has no value and is ignored.");
        return std::nullopt;
    }
    const std::string shown = item.key + "=" + in_quotes(item.value);
    if (!field.choices.empty()) {
        const auto found = std::find(field.choices.begin(), field.choices.end(), lower_case(item.value));
        if (found == field.choices.end()) {
            messages.add(shown + " is not one of " + listed(field.choices, "or") + " and is ignored.");
            return std::nullopt;
        }
        return found - field.choices.begin();
    }
    const Decimal number = read_decimal(item.value, field.unit.decimals);
    if (number.error != DecimalError::none) {
        messages.add(shown + std::string(reason(number.error)));
        return std::nullopt;
    }
    const std::int64_t within = grid_within_limits(field, number.value);
    if (!field.wraps && within != number.value) {
        messages.add(shown + (number.value < within ? " is below" : " is above") + " the limit; " +
                     with_unit(field, within) + " is used.");
    }
    return within;
}

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
        messages.add(in_quotes(item.key) + " is not something a link can set and is ignored.");
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

/// Reads a whole number within limits, clamped and named; nothing, having said why, if it is none.
std::optional<std::int64_t> read_count(const Item& item, std::int64_t lowest, std::int64_t highest,
                                       Messages& messages)
{
    const std::string shown = item.key + "=" + in_quotes(item.value);
    const Decimal number = read_decimal(item.value, 0);
    if (number.error != DecimalError::none) {
        messages.add(item.value.empty() ? in_quotes(item.key) + " has no value and is ignored."
                                        : shown + std::string(reason(number.error)));
        return std::nullopt;
    }
    const std::int64_t within = std::clamp(number.value, lowest, highest);
    if (within != number.value) {
        messages.add(shown + (number.value < within ? " is below" : " is above") + " the limit; " +
                     write_decimal(within, 0) + " is used.");
    }
    return within;
}

/// Returns the replay that the items ask for, where they do not say otherwise that of the task.
Replay read_replay(std::span<const Item> items, Replay replay, Messages& messages)
{
    bool is_asked = false;
    bool has_kind = replay.kind != EventKind::none;
    for (const Item& item : items) {
        if (item.key == "event") {
            const auto found = std::find(EVENT_NAMES.begin(), EVENT_NAMES.end(), lower_case(item.value));
            if (found == EVENT_NAMES.end()) {
                messages.add("event=" + in_quotes(item.value) + " is not one of " +
                             listed(EVENT_NAMES, "or") + " and is ignored.");
                continue;
            }
            replay.kind = static_cast<EventKind>(found - EVENT_NAMES.begin());
            has_kind = true;
        } else if (item.key == "tick") {
            if (const auto tick = read_count(item, 0, LONGEST_REPLAY, messages)) {
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
        const std::optional<std::size_t> found = find_task(*kind, lower_case(item.value));
        if (!found) {
            messages.add("There is no " + item.key + " " + in_quotes(item.value) + "; it is ignored.");
            continue;
        }
        if (task && tasks()[*task].kind != *kind) {
            messages.add("The link names a task and a figure; the last one is used.");
        }
        task = found;
    }
    return task;
}

void report_duplicates(std::span<const Item> items, Messages& messages)
{
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (items[j].key == items[i].key) {
                messages.add(in_quotes(items[i].key) + " is given more than once; the last value is used.");
                break;
            }
        }
    }
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

/// Puts an opened state in the place of one in use.
void replace(State& state, State opened)
{
    opened.revision = state.revision;
    ++opened.revision.count;
    ++opened.revision.openings;
    state = opened;
}

std::string written_value(const Field& field, std::int64_t value)
{
    return field.choices.empty() ? write_decimal(value, field.unit.decimals)
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
            append_item(result, "tick", write_decimal(replay.tick, 0));
        }
        if (replay.seed != of_start.seed) {
            append_item(result, "seed", write_decimal(replay.seed, 0));
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
    result.revision = state.revision;
    return result;
}

LinkResult open_link(State& state, std::string_view fragment)
{
    Messages messages;
    if (fragment.size() > LONGEST_LINK) {
        messages.add("The link is longer than " + write_decimal(LONGEST_LINK, 0) +
                     " characters and is not used.");
        return {messages.take()};
    }
    if (!fragment.empty() && fragment[0] == '#') {
        fragment.remove_prefix(1);
    }
    const std::vector<Item> items = read_items(fragment, messages);
    report_duplicates(items, messages);
    replace(state, read_state(items, read_task(items, messages), messages));
    return {messages.take()};
}

void open_task(State& state, std::size_t task)
{
    replace(state, starting_state(task));
}

} // namespace app
