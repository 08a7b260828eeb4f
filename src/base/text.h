#pragma once

#include <span>
#include <string>
#include <string_view>

namespace base {

/// Returns the text in quotation marks for a message: at most 40 bytes of it, cut between characters, then
/// "..."; with `?` for control characters, by which a link would rule a terminal.
std::string in_quotes(std::string_view text);

/// Returns "a", "a and b", "a, b and c"; "" for none.
std::string listed(std::span<const std::string_view> items, std::string_view conjunction = "and");

/// Returns the text with A to Z made small; other bytes stay.
std::string lower_case(std::string_view text);

} // namespace base
