#pragma once

#include "app/state/groups.h"
#include "app/state/state.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace app {

/// Names every value of the state that people can set. Links, sliders, JSON and `set` commands are made from
/// the table of fields, in this order.
enum class FieldId : std::uint8_t
{
    turret,
    main_gun,
    secondary_gun,
    secondary_gun_pitch,
    wheels_left,
    wheels_right,
    heading,
    x,
    z,
    orbit,
    tilt,
    distance,
    look_x,
    look_y,
    look_z,
    view,
    chase,
    ground,
    probe,
    point_x,
    point_y,
    point_z,
    point_radius,
    line_ax,
    line_ay,
    line_az,
    line_bx,
    line_by,
    line_bz,
    handle,
    speed,
    aim_x,
    aim_y,
    spheres,
    fit,
    triangles,
    particles,
    amount,
    detail,
    threshold,
    parts,
    axis,
    wireframe,
    tank,
};

constexpr std::size_t FIELD_COUNT = 44;

/// Says how a field is written for people, and how fine.
/// One unit has 10^decimals steps of the grid; a step is numerator / denominator in the state's own unit
/// (radians or metres).
struct Unit
{
    std::string_view name; ///< "degrees", "metres", "metres per second" or ""
    int decimals;
    double numerator;
    double denominator;
};

/// Describes one value of the state. Values on the grid are whole counts of the unit's steps.
struct Field
{
    FieldId id;
    std::string_view name;  ///< in links, JSON and commands
    std::string_view title; ///< for people
    Group group;
    Unit unit;
    double minimum; ///< in radians or metres, as in the state
    double maximum;
    bool wraps;                                ///< values are kept in [minimum, maximum) by going round
    std::int64_t initial;                      ///< the default, on the grid
    std::span<const std::string_view> choices; ///< if not empty, the value is an index of these
    double (*get)(const State&);               ///< in radians, metres, or the index
    void (*set)(State&, double); ///< stores the value as it is; callers bring it within the limits
};

/// Names several fields that one link key and one command set together.
struct FieldAlias
{
    std::string_view name;
    std::string_view title;
    std::array<FieldId, 2> fields;
};

/// Returns the table of fields, in the order of FieldId.
std::span<const Field> fields();

/// Returns the row of a field.
const Field& field(FieldId id);

/// Returns the field with that link name, or null.
const Field* find_field(std::string_view name);

/// Returns whether what a replay shows depends on the field: those of the camera, of what is drawn and of the
/// levels do not matter to where the projectile flies and what it meets.
bool matters_to_replay(const Field& field);

/// Returns the table of aliases.
std::span<const FieldAlias> field_aliases();

/// Returns a value in the state's unit, brought within the field's limits: gone round, or clamped.
/// Precondition: value is finite.
double within_limits(const Field& field, double value);

/// Returns the step of the grid nearest to a value in the state's unit, within the limits.
/// Halves go away from zero. Precondition: value is finite.
std::int64_t to_grid(const Field& field, double value);

/// Returns the step of the grid nearest to a value in the unit for people (degrees, metres, or an index),
/// within the limits. Precondition: value is finite.
std::int64_t to_grid_from_unit(const Field& field, double value);

/// Returns the lowest and the highest value on the grid. For a field that wraps, the highest is one step
/// below the end.
std::int64_t grid_minimum(const Field& field);
std::int64_t grid_maximum(const Field& field);

/// Returns a value of the grid, brought within the limits: gone round, or clamped.
std::int64_t grid_within_limits(const Field& field, std::int64_t value);

/// Returns the field's value in the state as a count of steps of the grid.
std::int64_t grid_value(const Field& field, const State& state);

/// Sets the field from a count of steps of the grid, brought within the limits.
/// grid_value() then gives the same count back.
void set_grid_value(const Field& field, State& state, std::int64_t value);

} // namespace app
