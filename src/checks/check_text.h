#pragma once

#include "tank/part.h"

#include <bitset>
#include <string>

namespace checks {

/// A set of parts, by tank::index_of.
using PartSet = std::bitset<tank::PART_COUNT>;

/// Returns "turret, main_gun and 14 more": the first names of a set. "nothing" for the empty set.
inline std::string named(const PartSet& parts)
{
    constexpr std::size_t MAX_NAMES = 4;
    std::string text;
    std::size_t names = 0;
    for (tank::Part part : tank::ALL_PARTS) {
        if (parts[tank::index_of(part)] && names < MAX_NAMES) {
            text += (names == 0 ? "" : ", ") + std::string(tank::part_name(part));
            ++names;
        }
    }
    if (parts.count() > names) {
        text += " and " + std::to_string(parts.count() - names) + " more";
    }
    return text.empty() ? "nothing" : text;
}

} // namespace checks
