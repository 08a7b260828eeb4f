#pragma once

#include "app/state/outcome.h"
#include "app/state/state.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A longer fragment is refused as a whole. Bytes.
constexpr std::size_t MAX_LINK_BYTES = 4096;

/// Says what came of a link.
struct LinkResult
{
    std::vector<std::string> messages; ///< what could not be used as it stands: one sentence each, for people
    Outcome outcome;                   ///< opened, if the state is that of the link
};

/// Returns the state as the fragment of a link, without '#': the task, then the fields that differ from what
/// the task begins with, in the table's order, rounded to the grid; then, if the state has an event that can
/// be replayed, `event`, `tick` and `seed`. The default state gives "".
std::string link(const State& state);

/// Replaces the state by the one a fragment describes.
/// A task or figure is loaded first; the other keys change what it begins with, the last of equal keys
/// winning. `event` (open or fire) happens in what these give, `tick` steps ago, at most MAX_REPLAY_TICKS,
/// with the random numbers of `seed`; a tick or a seed alone means the event `open`. Unknown keys and bad
/// values are named and ignored, values beyond a limit are clamped and named, the rest is used. A leading
/// '#', '&' or ';' between items, empty items, percent-encoding, spaces and signs
/// '+' are all right. A fragment longer than MAX_LINK_BYTES is named and leaves the state as it was.
LinkResult open_link(State& state, std::string_view fragment);

/// Returns the state that a link of this one gives back: its fields on the grid, its task, its event with the
/// shot as many ticks after it, nothing held; without an event, tick 0 and nothing in flight.
/// open_link(link(s)) == snapped(s), and link(snapped(s)) == link(s).
State snapped(const State& state);

/// Returns the state that a task begins with; the default state for none.
State starting_state(std::optional<std::size_t> task);

} // namespace app
