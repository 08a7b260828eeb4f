#include "app/state/fields.h"

#include "particles/presets.h"
#include "particles/settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

namespace app {

namespace {

using std::numbers::pi;
using tank::Joint;

constexpr Unit DEGREES{.name = "degrees", .decimals = 2, .numerator = pi, .denominator = 18000.0};
constexpr Unit METRES{.name = "metres", .decimals = 3, .numerator = 1.0, .denominator = 1000.0};
constexpr Unit METRES_PER_SECOND{
    .name = "metres per second", .decimals = 1, .numerator = 1.0, .denominator = 10.0};
constexpr Unit WINDOW_HEIGHTS{.name = "", .decimals = 4, .numerator = 1.0, .denominator = 10000.0};
constexpr Unit CHOICE{.name = "", .decimals = 0, .numerator = 1.0, .denominator = 1.0};

constexpr std::array<std::string_view, 2> OFF_ON = {"off", "on"};
constexpr std::array<std::string_view, 4> VIEWS = {"orbit", "follow", "gunner", "four"};
constexpr std::array<std::string_view, 5> PROBES = {"none", "point", "segment", "ray", "line"};
constexpr std::array<std::string_view, 3> HANDLES = {"point", "line_a", "line_b"};
constexpr std::array<std::string_view, 5> SPHERES = {"off", "penetrated", "whole", "parts", "all"};
constexpr std::array<std::string_view, 2> TANKS = {"lab", "own"};
constexpr std::array<std::string_view, 2> FITS = {"average", "smallest"};
constexpr std::array<std::string_view, 4> DETAILS = {"auto", "high", "low", "both"};
constexpr std::array<std::string_view, 6> PARTS = {"all",      "body",          "turret",
                                                   "main_gun", "secondary_gun", "wheels"};
constexpr std::array<std::string_view, 8> AXES = {
    "off", "body", "turret", "main_gun", "secondary_gun", "secondary_gun_pitch", "wheels", "moving"};

/// Returns "none" and the names of the presets.
std::span<const std::string_view> particle_choices()
{
    static const std::vector<std::string_view> CHOICES = [] {
        std::vector<std::string_view> choices = {"none"};
        for (const particles::Preset& preset : particles::presets()) {
            choices.push_back(preset.id);
        }
        return choices;
    }();
    return CHOICES;
}

constexpr double from_degrees(double degrees)
{
    return degrees * pi / 180.0;
}

struct Place
{
    double (*get)(const State&);
    void (*set)(State&, double);
};

template <Joint joint> constexpr Place in_joint()
{
    return {[](const State& state) { return state.joints[joint]; },
            [](State& state, double value) { state.joints[joint] = value; }};
}

/// Returns the member that a path of pointers to members leads to.
template <auto first, auto... rest> constexpr auto& at(auto& object)
{
    if constexpr (sizeof...(rest) == 0) {
        return object.*first;
    } else {
        return at<rest...>(object.*first);
    }
}

/// Values other than double, such as choices, are kept as what they are and given as a number.
template <auto... path> constexpr Place in_state()
{
    return {[](const State& state) { return static_cast<double>(at<path...>(state)); },
            [](State& state, double value) {
                auto& place = at<path...>(state);
                place = static_cast<std::remove_reference_t<decltype(place)>>(value);
            }};
}

template <auto member> constexpr Place in_camera()
{
    return in_state<&State::camera, member>();
}

template <auto member> constexpr Place in_camera_look()
{
    return in_state<&State::camera, &Camera::look, member>();
}

template <auto... path> constexpr Place in_projectile()
{
    return in_state<&State::projectile, path...>();
}

template <auto member> constexpr Place in_show()
{
    return in_state<&State::show, member>();
}

template <Joint joint>
Field joint_field(FieldId id, std::string_view name, std::string_view title, Group group)
{
    const tank::JointLimits limits = tank::joint_limits(joint);
    const Place place = in_joint<joint>();
    return {.id = id,
            .name = name,
            .title = title,
            .group = group,
            .unit = DEGREES,
            .minimum = limits.minimum,
            .maximum = limits.maximum,
            .wraps = limits.wraps,
            .initial = 0,
            .choices = {},
            .get = place.get,
            .set = place.set};
}

struct Range
{
    double minimum;
    double maximum;
    std::int64_t initial; ///< on the grid
    bool wraps = false;
};

Field plain_field(FieldId id, std::string_view name, std::string_view title, Group group, const Unit& unit,
                  const Range& range, const Place& place)
{
    return {.id = id,
            .name = name,
            .title = title,
            .group = group,
            .unit = unit,
            .minimum = range.minimum,
            .maximum = range.maximum,
            .wraps = range.wraps,
            .initial = range.initial,
            .choices = {},
            .get = place.get,
            .set = place.set};
}

Field choice_field(FieldId id, std::string_view name, std::string_view title, Group group,
                   std::span<const std::string_view> choices, std::int64_t initial, const Place& place)
{
    const Range range{.minimum = 0.0, .maximum = static_cast<double>(choices.size() - 1), .initial = initial};
    Field field = plain_field(id, name, title, group, CHOICE, range, place);
    field.choices = choices;
    return field;
}

/// The eye goes no further away from what it looks at. Metres.
constexpr double FURTHEST = 400.0;

/// The near plane is never further away than this, so a threshold can be everywhere beyond it. Metres.
constexpr double MIN_THRESHOLD = 1.0;

/// The distance d that is shipped, in millimetres. `tanklab-render --measure-threshold` finds that no patches
/// differ from about 32 m on; there, side by side, an eye still finds the edges of camouflage, which the low
/// tank's corners blur. Here a tank is 28 pixels long: of the pairs of `scripts/model/blind.py`, as large as
/// in the window, a fresh eye named the high one in 20 of 36; doubled in size, one that knew what to look
/// for in 28 of 36.
constexpr std::int64_t DEFAULT_THRESHOLD = 259'000;

/// Where the projectile and its line can be: round everything that the tank can drive to. Metres.
constexpr Range reached(std::int64_t initial)
{
    return {.minimum = -300.0, .maximum = 300.0, .initial = initial};
}

constexpr Range raised(std::int64_t initial)
{
    return {.minimum = 0.0, .maximum = 100.0, .initial = initial};
}

// The camera's defaults show the whole tank, gun included, three quarters from the front in a 16:10 window.
// A tilt of at least 0 and a look_y above 0 keep the eye above the ground at every distance.
std::array<Field, FIELD_COUNT> make_fields()
{
    using enum FieldId;
    const Range across{.minimum = -200.0, .maximum = 200.0, .initial = 0};
    const Range beside{.minimum = -20.0, .maximum = 20.0, .initial = 0};
    return {{
        joint_field<Joint::turret>(turret, "turret", "Turret", Group::joints),
        joint_field<Joint::main_gun>(main_gun, "gun", "Main gun", Group::joints),
        joint_field<Joint::secondary_gun>(secondary_gun, "secondary_gun", "Secondary gun", Group::joints),
        joint_field<Joint::secondary_gun_pitch>(secondary_gun_pitch, "secondary_gun_pitch",
                                                "Secondary gun's pitch", Group::joints),
        joint_field<Joint::wheels_left>(wheels_left, "wheels_left", "Left wheels", Group::joints),
        joint_field<Joint::wheels_right>(wheels_right, "wheels_right", "Right wheels", Group::joints),
        joint_field<Joint::heading>(heading, "heading", "Heading", Group::tank),
        plain_field(x, "x", "Position x", Group::tank, METRES, across, in_state<&State::x>()),
        plain_field(z, "z", "Position z", Group::tank, METRES, across, in_state<&State::z>()),
        plain_field(orbit, "orbit", "Orbit", Group::camera, DEGREES,
                    {.minimum = -pi, .maximum = pi, .initial = 4000, .wraps = true},
                    in_camera<&Camera::orbit>()),
        plain_field(tilt, "tilt", "Tilt", Group::camera, DEGREES,
                    {.minimum = 0.0, .maximum = from_degrees(89.0), .initial = 1500},
                    in_camera<&Camera::tilt>()),
        plain_field(distance, "distance", "Distance", Group::camera, METRES,
                    {.minimum = 4.0, .maximum = FURTHEST, .initial = 10500}, in_camera<&Camera::distance>()),
        plain_field(look_x, "look_x", "Look at x", Group::camera, METRES, beside,
                    in_camera_look<&glm::dvec3::x>()),
        plain_field(look_y, "look_y", "Look at y", Group::camera, METRES,
                    {.minimum = 0.1, .maximum = 10.0, .initial = 1450}, in_camera_look<&glm::dvec3::y>()),
        plain_field(look_z, "look_z", "Look at z", Group::camera, METRES,
                    {.minimum = -20.0, .maximum = 20.0, .initial = 1400}, in_camera_look<&glm::dvec3::z>()),
        choice_field(view, "view", "View", Group::camera, VIEWS, 0, in_camera<&Camera::view>()),
        plain_field(chase, "chase", "Off from behind", Group::camera, DEGREES,
                    {.minimum = -pi, .maximum = pi, .initial = 0, .wraps = true},
                    in_camera<&Camera::chase>()),
        choice_field(ground, "ground", "Ground", Group::camera, OFF_ON, 1, in_show<&Show::ground>()),
        choice_field(probe, "probe", "Tested", Group::projectile, PROBES, 0,
                     in_projectile<&Projectile::probe>()),
        plain_field(point_x, "point_x", "Projectile x", Group::projectile, METRES, reached(4000),
                    in_projectile<&Projectile::point, &glm::dvec3::x>()),
        plain_field(point_y, "point_y", "Projectile y", Group::projectile, METRES, raised(2500),
                    in_projectile<&Projectile::point, &glm::dvec3::y>()),
        plain_field(point_z, "point_z", "Projectile z", Group::projectile, METRES, reached(4000),
                    in_projectile<&Projectile::point, &glm::dvec3::z>()),
        plain_field(point_radius, "point_radius", "Projectile radius", Group::projectile, METRES,
                    {.minimum = 0.0, .maximum = 5.0, .initial = 0}, in_projectile<&Projectile::radius>()),
        plain_field(line_ax, "line_ax", "Line from x", Group::projectile, METRES, reached(7000),
                    in_projectile<&Projectile::a, &glm::dvec3::x>()),
        plain_field(line_ay, "line_ay", "Line from y", Group::projectile, METRES, raised(3500),
                    in_projectile<&Projectile::a, &glm::dvec3::y>()),
        plain_field(line_az, "line_az", "Line from z", Group::projectile, METRES, reached(5000),
                    in_projectile<&Projectile::a, &glm::dvec3::z>()),
        plain_field(line_bx, "line_bx", "Line to x", Group::projectile, METRES, reached(-4000),
                    in_projectile<&Projectile::b, &glm::dvec3::x>()),
        plain_field(line_by, "line_by", "Line to y", Group::projectile, METRES, raised(1200),
                    in_projectile<&Projectile::b, &glm::dvec3::y>()),
        plain_field(line_bz, "line_bz", "Line to z", Group::projectile, METRES, reached(-3000),
                    in_projectile<&Projectile::b, &glm::dvec3::z>()),
        choice_field(handle, "handle", "Moved by keys", Group::projectile, HANDLES, 0,
                     in_projectile<&Projectile::handle>()),
        plain_field(speed, "speed", "Speed", Group::projectile, METRES_PER_SECOND,
                    {.minimum = 1.0, .maximum = 5000.0, .initial = 150}, in_projectile<&Projectile::speed>()),
        plain_field(aim_x, "aim_x", "Aim to the right", Group::projectile, WINDOW_HEIGHTS,
                    {.minimum = -4.0, .maximum = 4.0, .initial = 0},
                    in_projectile<&Projectile::aim, &glm::dvec2::x>()),
        plain_field(aim_y, "aim_y", "Aim up", Group::projectile, WINDOW_HEIGHTS,
                    {.minimum = -4.0, .maximum = 4.0, .initial = 0},
                    in_projectile<&Projectile::aim, &glm::dvec2::y>()),
        choice_field(spheres, "spheres", "Spheres shown", Group::spheres, SPHERES, 1,
                     in_show<&Show::spheres>()),
        choice_field(fit, "fit", "Spheres computed", Group::spheres, FITS, 0, in_show<&Show::fit>()),
        choice_field(triangles, "triangles", "Triangles tested", Group::spheres, OFF_ON, 0,
                     in_show<&Show::triangles>()),
        choice_field(particles, "particles", "Particles", Group::particles, particle_choices(), 0,
                     in_state<&State::particles, &ParticleShow::preset>()),
        plain_field(amount, "amount", "Most particles", Group::particles, CHOICE,
                    {.minimum = 0.0, .maximum = particles::MAX_PARTICLES, .initial = 500},
                    in_state<&State::particles, &ParticleShow::amount>()),
        choice_field(detail, "detail", "Model", Group::detail, DETAILS, 0, in_show<&Show::detail>()),
        plain_field(threshold, "threshold", "Threshold distance", Group::detail, METRES,
                    {.minimum = MIN_THRESHOLD, .maximum = FURTHEST, .initial = DEFAULT_THRESHOLD},
                    in_show<&Show::threshold>()),
        choice_field(parts, "parts", "Parts drawn", Group::picture, PARTS, 0, in_show<&Show::parts>()),
        choice_field(axis, "axis", "Axis drawn", Group::picture, AXES, 0, in_show<&Show::axis>()),
        choice_field(wireframe, "wireframe", "Wireframe", Group::picture, OFF_ON, 0,
                     in_show<&Show::wireframe>()),
        choice_field(tank, "tank", "Whose tank", Group::picture, TANKS, 0, in_state<&State::tank>()),
    }};
}

constexpr std::array<FieldAlias, 1> ALIASES = {{
    {.name = "wheels", .title = "Wheels", .fields = {FieldId::wheels_left, FieldId::wheels_right}},
}};

std::int64_t round_to_grid(const Unit& unit, double value)
{
    return std::llround(value * unit.denominator / unit.numerator);
}

} // namespace

std::span<const Field> fields()
{
    static const std::array<Field, FIELD_COUNT> FIELDS = make_fields();
    return FIELDS;
}

const Field& field(FieldId id)
{
    return fields()[static_cast<std::size_t>(id)];
}

const Field* find_field(std::string_view name)
{
    for (const Field& field : fields()) {
        if (field.name == name) {
            return &field;
        }
    }
    return nullptr;
}

bool matters_to_replay(const Field& field)
{
    if (field.id == FieldId::tank) {
        return true; // what is met on the way are its spheres
    }
    switch (field.group) {
    case Group::picture:
    case Group::camera:
    case Group::detail:
    case Group::program:
        return false;
    default:
        return field.id != FieldId::spheres && field.id != FieldId::triangles;
    }
}

std::span<const FieldAlias> field_aliases()
{
    return ALIASES;
}

double within_limits(const Field& field, double value)
{
    // The limits have the form of a joint's, so going round is written once, in tank/.
    return tank::within_limits({.wraps = field.wraps, .minimum = field.minimum, .maximum = field.maximum},
                               value);
}

std::int64_t to_grid(const Field& field, double value)
{
    return grid_within_limits(field, round_to_grid(field.unit, within_limits(field, value)));
}

std::int64_t to_grid_from_unit(const Field& field, double value)
{
    double steps_per_unit = 1.0;
    for (int i = 0; i < field.unit.decimals; ++i) {
        steps_per_unit *= 10.0;
    }
    const auto lowest = static_cast<double>(grid_minimum(field));
    const auto highest = static_cast<double>(grid_maximum(field));
    // Brought near the limits before it is scaled and made whole, so that nothing overflows.
    if (field.wraps) {
        const double round = highest - lowest + 1.0;
        return grid_within_limits(
            field, std::llround(std::remainder(value, round / steps_per_unit) * steps_per_unit));
    }
    return std::llround(std::clamp(value * steps_per_unit, lowest, highest));
}

std::int64_t grid_minimum(const Field& field)
{
    return round_to_grid(field.unit, field.minimum);
}

std::int64_t grid_maximum(const Field& field)
{
    return round_to_grid(field.unit, field.maximum) - (field.wraps ? 1 : 0);
}

std::int64_t grid_within_limits(const Field& field, std::int64_t value)
{
    const std::int64_t lowest = grid_minimum(field);
    const std::int64_t highest = grid_maximum(field);
    if (!field.wraps || (value >= lowest && value <= highest)) {
        return std::clamp(value, lowest, highest);
    }
    const std::int64_t round = highest - lowest + 1;
    const std::int64_t past = (value % round - lowest % round) % round; // in (-round, round), no overflow
    return lowest + (past < 0 ? past + round : past);
}

std::int64_t grid_value(const Field& field, const State& state)
{
    return to_grid(field, field.get(state));
}

void set_grid_value(const Field& field, State& state, std::int64_t value)
{
    const auto steps = static_cast<double>(grid_within_limits(field, value));
    // Clamped once more: a limit itself need not be a product of a step and a whole number to the last bit.
    field.set(state, std::clamp(steps * field.unit.numerator / field.unit.denominator, field.minimum,
                                field.maximum));
}

} // namespace app
