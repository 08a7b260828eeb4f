#pragma once

#include "app/state.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A longer fragment is refused as a whole. Bytes.
constexpr std::size_t LONGEST_LINK = 4096;

/// Holds what a link had in it that could not be used as it stands: one sentence each, for people.
struct LinkResult
{
    std::vector<std::string> messages;
};

/// Returns the state as the fragment of a link, without '#': the task, then the fields that differ from what
/// the task begins with, in the table's order, rounded to the grid. The default state gives "".
std::string link(const State& state);

/// Replaces the state by the one a fragment describes, and counts up its revision.
/// A task or figure is loaded first; the other keys change what it begins with, the last of equal keys
/// winning. Unknown keys and bad values are named and ignored, values beyond a limit are clamped and named,
/// the rest is used. A leading '#', '&' or ';' between items, empty items, percent-encoding, spaces and signs
/// '+' are all right. A fragment longer than LONGEST_LINK is named and leaves the state as it was.
LinkResult open_link(State& state, std::string_view fragment);

/// Returns the state that a link of this one gives back: its fields on the grid, its task, nothing held, tick
/// 0. open_link(link(s)) == snapped(s), and link(snapped(s)) == link(s).
State snapped(const State& state);

/// Returns the state that a task begins with; the default state for none.
State starting_state(std::optional<std::size_t> task);

} // namespace app
