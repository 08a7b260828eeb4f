#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace tank {

/// Names the 18 parts of the tank. A parent always comes before its children. Wheel 1 is the front one; left
/// is +X.
enum class Part
{
    body,
    turret,
    main_gun,
    secondary_gun,
    wheel_left_1,
    wheel_left_2,
    wheel_left_3,
    wheel_left_4,
    wheel_left_5,
    wheel_left_6,
    wheel_left_7,
    wheel_right_1,
    wheel_right_2,
    wheel_right_3,
    wheel_right_4,
    wheel_right_5,
    wheel_right_6,
    wheel_right_7,
};

constexpr std::size_t PART_COUNT = 18;
constexpr int WHEELS_PER_SIDE = 7;

/// Names the five meshes that the parts share.
enum class MeshKind
{
    body,
    turret,
    main_gun,
    secondary_gun,
    wheel,
};

constexpr std::size_t MESH_KIND_COUNT = 5;

/// Lists every part in the order of the enumeration, for loops.
constexpr std::array<Part, PART_COUNT> ALL_PARTS = [] {
    std::array<Part, PART_COUNT> parts{};
    for (std::size_t i = 0; i < PART_COUNT; ++i) {
        parts[i] = static_cast<Part>(i);
    }
    return parts;
}();

/// Returns the index of a part, in [0, PART_COUNT).
constexpr std::size_t index_of(Part part)
{
    return static_cast<std::size_t>(part);
}

/// Returns the index of a mesh kind, in [0, MESH_KIND_COUNT).
constexpr std::size_t index_of(MeshKind mesh)
{
    return static_cast<std::size_t>(mesh);
}

/// Returns what people call a mesh, such as "main gun".
std::string_view mesh_title(MeshKind mesh);

/// Returns the name used in links and on the page, such as "main_gun" or "wheel_left_3".
std::string_view part_name(Part part);

} // namespace tank
