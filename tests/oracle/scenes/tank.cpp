// The program's own picture: the assembled tank from four cameras in three poses, as a link describes them.

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

[[maybe_unused]] const bool registered = [] {
    for (const Named& camera : CAMERAS)
        for (const Named& pose : POSES)
            oracle::add_link(std::string("tank_") + camera.name + "_" + pose.name,
                             std::string(camera.link) + "&" + pose.link);
    return true;
}();

} // namespace
