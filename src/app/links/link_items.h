#pragma once

#include "app/state/fields.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// One key=value of a link.
struct Item
{
    std::string key; ///< lower case
    std::string value;
};

/// Collects messages, each once, and says how many there were beyond the most that people would read.
class Messages
{
public:
    void add(std::string message);
    std::vector<std::string> take();

private:
    std::vector<std::string> messages_;
    int more_ = 0;
};

/// Takes a link's fragment, without '#', apart: items between '&' or ';', percent-decoded, empty ones left
/// out. Says which are not well-formed; those are left out.
std::vector<Item> read_items(std::string_view fragment, Messages& messages);

/// Says which keys are given more than once.
void report_duplicates(std::span<const Item> items, Messages& messages);

/// Returns an item's value on the field's grid, clamped to its limits, which is said; nothing, having said
/// why, if the field has no such value.
std::optional<std::int64_t> read_value(const Field& field, const Item& item, Messages& messages);

/// Returns an item's value as a whole number within limits, clamped to them, which is said; nothing, having
/// said why, if it is not one.
std::optional<std::int64_t> read_count(const Item& item, std::int64_t lowest, std::int64_t highest,
                                       Messages& messages);

} // namespace app
