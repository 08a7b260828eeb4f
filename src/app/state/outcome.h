#pragma once

#include "app/state/fields.h"

#include <bitset>
#include <string>
#include <utility>

namespace app {

/// Fields by FieldId.
using FieldSet = std::bitset<FIELD_COUNT>;

/// Says what became of a command, a tick or a link: why it was refused, or what has changed and happened.
/// What a Simulation alone can know, apply() and step() of a bare state leave false.
struct Outcome
{
    std::string refusal = {}; ///< "" or a sentence that says why nothing was done; nothing else is set then

    FieldSet fields = {};       ///< whose values are others
    bool holds_changed = false; ///< other commands are held
    bool event_changed = false; ///< the event has begun, gone on or ended, or what it has fired has moved

    bool opened = false;  ///< a link or a task was opened: anything may be another
    bool printed = false; ///< the hit report was asked for
    bool fired = false;   ///< the projectile was fired, with random numbers of its own
    bool landed = false;  ///< its flight has ended: it is back where it rests

    bool hit = false;           ///< it has touched the sphere of a part (Simulation)
    bool switched = false;      ///< the level by distance is another (Simulation)
    bool tank_replaced = false; ///< another tank is shown (Simulation)
    bool animated = false;      ///< sparks or particles fly, or a joint has come to rest (Simulation)

    static Outcome refused(std::string why)
    {
        Outcome outcome;
        outcome.refusal = std::move(why);
        return outcome;
    }

    /// Returns whether people see something else than before. Ticks alone are nothing to see.
    bool is_visible() const
    {
        return fields.any() || holds_changed || event_changed || opened || printed || switched ||
               tank_replaced || animated;
    }

    /// Takes in what happened next. The last refusal counts.
    Outcome& operator|=(const Outcome& next)
    {
        if (!next.refusal.empty()) {
            refusal = next.refusal;
        }
        fields |= next.fields;
        for (bool Outcome::* flag : {&Outcome::holds_changed, &Outcome::event_changed, &Outcome::opened,
                                     &Outcome::printed, &Outcome::fired, &Outcome::landed, &Outcome::hit,
                                     &Outcome::switched, &Outcome::tank_replaced, &Outcome::animated}) {
            this->*flag = this->*flag || next.*flag;
        }
        return *this;
    }
};

} // namespace app
