#pragma once

#include "app/state/outcome.h"
#include "collision/part_set.h"
#include "tank/joint.h"
#include "tank/layout.h"

#include <array>
#include <cstdint>
#include <optional>

namespace app {

/// Follows a state and knows which joints move right now: those that have changed within the last two fifths
/// of a second, so that a drag, which comes in jumps, is one movement. Driving moves the body, as turning it
/// does. Plain data; it belongs to the viewer, not to a link.
class Motion
{
public:
    /// Takes in which fields a command or a step has changed.
    void follow(const FieldSet& changed);

    /// Advances by one tick, before what that tick moves is taken in. Returns whether a joint has come to
    /// rest.
    bool step();

    /// Lets everything rest, as when a link is opened.
    void forget() { *this = {}; }

    /// Returns the parts whose joints move, without those that they carry along.
    collision::PartSet parts(const tank::Layout& layout) const;

    /// Returns the joint of the one of these that is furthest from the body in the tree, the first of
    /// several; of its two the inner one, if that moves.
    std::optional<tank::Joint> foremost(const tank::Layout& layout) const;

private:
    bool moves(tank::Joint joint) const { return ticks_left_[tank::index_of(joint)] > 0; }

    std::array<std::uint8_t, tank::JOINT_COUNT> ticks_left_{};
};

} // namespace app
