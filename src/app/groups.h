#pragma once

#include <string_view>

namespace app {

/// Names the headings under which the page shows commands and fields, in this order.
enum class Group
{
    turret,
    main_gun,
    secondary_gun,
    wheels,
    tank,
    projectile,
    spheres,
    particles,
    detail,
    picture,
    camera,
    program,
};

/// Returns the heading for people, such as "Main gun".
constexpr std::string_view group_name(Group group)
{
    switch (group) {
    case Group::turret:
        return "Turret";
    case Group::main_gun:
        return "Main gun";
    case Group::secondary_gun:
        return "Secondary gun";
    case Group::wheels:
        return "Wheels";
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
