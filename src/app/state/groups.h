#pragma once

#include <string_view>

namespace app {

/// Names the headings under which the page shows commands and fields, in this order.
enum class Group
{
    joints,
    tank,
    projectile,
    spheres,
    particles,
    detail,
    picture,
    camera,
    program,
};

/// Returns the heading for people, such as "Level of detail".
constexpr std::string_view group_name(Group group)
{
    switch (group) {
    case Group::joints:
        return "Turret, guns and wheels";
    case Group::tank:
        return "Tank";
    case Group::projectile:
        return "Projectile";
    case Group::spheres:
        return "Spheres";
    case Group::particles:
        return "Particles";
    case Group::detail:
        return "Level of detail";
    case Group::picture:
        return "Picture";
    case Group::camera:
        return "Camera";
    case Group::program:
        return "Program";
    }
    return {};
}

} // namespace app
