// The program's own picture: the assembled tank from four cameras in three poses, as a link describes them;
// the program's other views; and the shadow seen from the side it falls to, of each level, of wires, of some
// parts, and where two of them meet.

#include "scenes/program.h"

namespace {

struct Named
{
    const char* name;
    const char* link;
};

constexpr Named CAMERAS[] = {{"front", "orbit=40&tilt=15&distance=11.5"},
                             {"rear", "orbit=-150&tilt=25&distance=13"},
                             {"side_low", "orbit=90&tilt=3&distance=9"},
                             {"far_above", "orbit=10&tilt=70&distance=45"}};
constexpr Named POSES[] = {{"rest", ""},
                           {"turned", "turret=60&gun=20&secondary_gun=45&wheels_left=20&wheels_right=-50"},
                           {"back", "turret=-165&gun=-9&secondary_gun=-120&heading=30&x=1.5&z=-2"}};

constexpr Named SHADOWS[] = {
    {"high", "orbit=-130&tilt=40&distance=11&look_x=-1.5&look_z=-1.5&turret=-60&gun=20&detail=high"},
    {"low", "orbit=-130&tilt=40&distance=11&look_x=-1.5&look_z=-1.5&turret=-60&gun=20&detail=low"},
    {"wires", "orbit=-130&tilt=40&distance=13&turret=120&gun=-9&wireframe=on"},
    {"of_the_gun_alone", "orbit=-130&tilt=30&parts=main_gun&heading=75"},
    {"of_two", "orbit=-160&tilt=30&distance=16&look_x=2.75&detail=both&turret=-90&heading=-120"},
    {"under_the_horizon", "orbit=40&tilt=1&distance=14&gun=20"},
    {"from_afar", "orbit=-130&tilt=20&distance=120"},
};

constexpr Named VIEWS[] = {
    {"follow", "view=follow&heading=60&turret=-20&chase=30"},
    {"gunner", "view=gunner&turret=-35&gun=-9"},
    {"gunner_zoomed", "view=gunner&distance=4&gun=3&probe=point&point_x=1&point_y=2.5&point_z=40"},
    {"four", "view=four&turret=30"},
    {"four_of_all", "view=four&turret=-70&probe=line&spheres=all&axis=turret&task=2.6&tick=52"},
    {"four_of_wires", "view=four&wireframe=on&detail=low"},
};

[[maybe_unused]] const bool registered = [] {
    for (const Named& camera : CAMERAS) {
        for (const Named& pose : POSES) {
            oracle::add_link(std::string("tank_") + camera.name + "_" + pose.name,
                             std::string(camera.link) + "&" + pose.link);
        }
    }
    for (const Named& view : VIEWS) {
        oracle::add_link(std::string("view_") + view.name, view.link);
    }
    for (const Named& shadow : SHADOWS) {
        oracle::add_link(std::string("shadow_") + shadow.name, shadow.link);
    }
    return true;
}();

} // namespace
