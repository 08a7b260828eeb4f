#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace lod {

/// Names the two models of the tank: the full one and the coarse one for a distance.
enum class Level : std::uint8_t
{
    high,
    low,
};

constexpr std::size_t LEVEL_COUNT = 2;

/// Returns "high" or "low".
constexpr std::string_view level_name(Level level)
{
    return level == Level::high ? "high" : "low";
}

} // namespace lod
