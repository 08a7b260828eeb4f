#include "app/simulation/motion.h"

#include "app/state/ticks.h"

namespace app {

namespace {

constexpr std::uint8_t LINGERS = 2 * TICKS_PER_SECOND / 5;

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

void Motion::follow(const State& before, const State& after)
{
    for (std::size_t joint = 0; joint < tank::JOINT_COUNT; ++joint) {
        if (before.joints.radians[joint] != after.joints.radians[joint]) {
            ticks_left_[joint] = LINGERS;
        }
    }
    if (before.x != after.x || before.z != after.z) {
        ticks_left_[tank::index_of(tank::Joint::heading)] = LINGERS;
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
