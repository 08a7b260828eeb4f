#include "tank/part.h"

namespace tank {

namespace {

constexpr std::array<std::string_view, PART_COUNT> NAMES = {
    "body",          "turret",        "main_gun",      "secondary_gun", "wheel_left_1",  "wheel_left_2",
    "wheel_left_3",  "wheel_left_4",  "wheel_left_5",  "wheel_left_6",  "wheel_left_7",  "wheel_right_1",
    "wheel_right_2", "wheel_right_3", "wheel_right_4", "wheel_right_5", "wheel_right_6", "wheel_right_7",
};

} // namespace

std::string_view mesh_title(MeshKind mesh)
{
    constexpr std::string_view TITLES[MESH_KIND_COUNT] = {"body", "turret", "main gun", "secondary gun",
                                                          "wheel"};
    return TITLES[index_of(mesh)];
}

std::string_view part_name(Part part)
{
    return NAMES[index_of(part)];
}

} // namespace tank
