#include "app/simulation/motion.h"

#include "app/state/ticks.h"

#include <utility>

namespace app {

namespace {

constexpr std::uint8_t LINGERS = 2 * TICKS_PER_SECOND / 5;

/// Which joint moves with which field: driving moves the body, as turning it does.
constexpr std::pair<FieldId, tank::Joint> JOINT_OF_FIELD[] = {
    {FieldId::turret, tank::Joint::turret},
    {FieldId::main_gun, tank::Joint::main_gun},
    {FieldId::secondary_gun, tank::Joint::secondary_gun},
    {FieldId::secondary_gun_pitch, tank::Joint::secondary_gun_pitch},
    {FieldId::wheels_left, tank::Joint::wheels_left},
    {FieldId::wheels_right, tank::Joint::wheels_right},
    {FieldId::heading, tank::Joint::heading},
    {FieldId::x, tank::Joint::heading},
    {FieldId::z, tank::Joint::heading},
};

/// Returns how many joints lie between a part and the body.
int depth(const tank::Layout& layout, tank::Part part)
{
    int result = 0;
    for (; layout[part].parent != part; part = layout[part].parent) {
        ++result;
    }
    return result;
}

} // namespace

void Motion::follow(const FieldSet& changed)
{
    for (const auto& [field, joint] : JOINT_OF_FIELD) {
        if (changed.test(static_cast<std::size_t>(field))) {
            ticks_left_[tank::index_of(joint)] = LINGERS;
        }
    }
}

bool Motion::step()
{
    bool has_come_to_rest = false;
    for (std::uint8_t& ticks : ticks_left_) {
        if (ticks > 0) {
            --ticks;
            has_come_to_rest = has_come_to_rest || ticks == 0;
        }
    }
    return has_come_to_rest;
}

collision::PartSet Motion::parts(const tank::Layout& layout) const
{
    collision::PartSet parts;
    for (tank::Part part : tank::ALL_PARTS) {
        const tank::PartPlacement& placement = layout[part];
        if (moves(placement.joint) || (placement.second && moves(placement.second->joint))) {
            parts.insert(tank::index_of(part));
        }
    }
    return parts;
}

std::optional<tank::Joint> Motion::foremost(const tank::Layout& layout) const
{
    std::optional<tank::Part> found;
    parts(layout).for_each([&](std::size_t index) {
        const auto part = static_cast<tank::Part>(index);
        if (!found || depth(layout, part) > depth(layout, *found)) {
            found = part;
        }
    });
    if (!found) {
        return std::nullopt;
    }
    const tank::PartPlacement& placement = layout[*found];
    return placement.second && moves(placement.second->joint) ? placement.second->joint : placement.joint;
}

} // namespace app
