#pragma once

#include "tank/part.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace app {

/// Says which bounding spheres are drawn.
enum class SpheresShown : std::uint8_t
{
    off,
    penetrated, ///< those that the probe or the projectile is inside of
    whole,      ///< and the one around the whole tank
    parts,      ///< and those of all parts
    all,
};

/// Says how the parts' bounding spheres are computed from the meshes.
enum class SphereFit : std::uint8_t
{
    average,  ///< the lab's: around the average vertex
    smallest, ///< the smallest enclosing one
};

/// Says which model of the tank is drawn.
enum class Detail : std::uint8_t
{
    automatic, ///< low beyond the threshold distance, high inside it
    high,
    low,
    both, ///< side by side
};

/// Names sets of parts that can be drawn alone.
enum class PartsShown : std::uint8_t
{
    all,
    body,
    turret,
    main_gun,
    secondary_gun,
    wheels,
};

/// Says whether a part is drawn.
constexpr bool is_shown(PartsShown parts, tank::Part part)
{
    switch (parts) {
    case PartsShown::all:
        return true;
    case PartsShown::body:
        return part == tank::Part::body;
    case PartsShown::turret:
        return part == tank::Part::turret;
    case PartsShown::main_gun:
        return part == tank::Part::main_gun;
    case PartsShown::secondary_gun:
        return part == tank::Part::secondary_gun;
    case PartsShown::wheels:
        return part >= tank::Part::wheel_left_1;
    }
    return true;
}

/// Says whose axis is drawn.
enum class AxisShown : std::uint8_t
{
    off,
    body,
    turret,
    main_gun,
    secondary_gun,       ///< of its yaw
    secondary_gun_pitch, ///< of its pitch
    wheels,              ///< the front left one's
    moving,              ///< of the joint that moves; none while all rest
};

/// Holds what of the scene is drawn, and how.
struct Show
{
    bool ground = false;
    bool wireframe = false;
    bool triangles = false; ///< what is inside a part's sphere is tested against its triangles, too
    PartsShown parts = PartsShown::all;
    AxisShown axis = AxisShown::off;
    SpheresShown spheres = SpheresShown::off;
    SphereFit fit = SphereFit::average;
    Detail detail = Detail::automatic;
    double threshold = 0.0; ///< metres: the distance d at which the level is switched

    friend bool operator==(const Show&, const Show&) = default;
};

} // namespace app
