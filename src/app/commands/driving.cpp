#include "app/commands/driving.h"

#include <cmath>

namespace app {

namespace {

constexpr std::size_t row(FieldId id)
{
    return static_cast<std::size_t>(id);
}

/// Returns the sine as the same number on every machine: in double, rounded once.
double same_everywhere(double value)
{
    return static_cast<double>(static_cast<float>(value));
}

bool is_at_edge(const Field& field, const State& state, double rate)
{
    const double value = field.get(state);
    return (rate > 0.0 && value >= field.maximum) || (rate < 0.0 && value <= field.minimum);
}

} // namespace

void add_driving(FieldRates& rates, const State& state, const assets::Assets& assets, double forward)
{
    const double heading = state.joints[tank::Joint::heading];
    const double along_x = forward * same_everywhere(std::sin(heading));
    const double along_z = forward * same_everywhere(std::cos(heading));
    if (is_at_edge(field(FieldId::x), state, along_x) || is_at_edge(field(FieldId::z), state, along_z)) {
        forward = 0.0;
    } else {
        rates[row(FieldId::x)] += along_x;
        rates[row(FieldId::z)] += along_z;
    }
    if (assets.wheel_radius > 0.0) {
        // Turning left, the left side goes back and the right one forward.
        const double left = static_cast<double>(assets.layout[tank::Part::wheel_left_1].pivot.x);
        const double turned = rates[row(FieldId::heading)] * left;
        rates[row(FieldId::wheels_left)] += (forward - turned) / assets.wheel_radius;
        rates[row(FieldId::wheels_right)] += (forward + turned) / assets.wheel_radius;
    }
}

} // namespace app
