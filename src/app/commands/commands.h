#pragma once

#include "app/commands/keys.h"
#include "app/state/fields.h"
#include "app/state/groups.h"
#include "app/state/outcome.h"
#include "app/state/state.h"
#include "assets/assets.h"
#include "base/static_vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// Says what the value given to a command means.
/// hold: 1 begins, 0 ends; in between every step moves the fields at the command's rates.
/// press: 1 does it once; 0, the key coming up, does nothing.
/// add: the amount, added once. set: the new value, in the field's unit for people (degrees, metres) or an
/// index.
enum class CommandKind : std::uint8_t
{
    hold,
    press,
    add,
    set,
};

/// Says how a command changes one field.
/// hold: rate in radians or metres per second; add: radians or metres for a value of 1.
/// relative: the field is multiplied instead, by 1 + rate per second or per value, or divided when rate < 0,
/// so that
///           both directions undo each other; rate has no unit then.
/// set: the rate is not used.
struct Move
{
    FieldId field;
    double rate = 0.0;
    bool relative = false;
    bool of_handle =
        false; ///< the field is the point's coordinate; that of what Projectile::handle says moves
    bool along_heading = false; ///< the field is x or z; the rate is the tank's, straight ahead
};

/// Describes one thing that people can do. Unused keys are Key::none and come last.
struct Command
{
    std::string_view name;
    std::string_view title;
    Group group = Group::program;
    CommandKind kind = CommandKind::press;
    std::array<Key, 3> keys{};
    base::StaticVector<Move, 2> moves{};
    /// For press: does it, and says what happened besides other values of fields, which apply() finds.
    Outcome (*press)(State&, const assets::Assets&) = nullptr;
};

/// Returns the one table of commands: first those with keys and for the mouse, then a `set` command for every
/// field and alias, by its link name. Rows of kind `hold` have an index below MAX_HELD_COMMANDS.
std::span<const Command> commands();

/// Returns the command with that name, or null.
const Command* find_command(std::string_view name);

/// Returns the command that a key gives, or null.
const Command* command_for_key(Key key);

/// Converts the mouse's movement to the values of orbit_by and tilt_by, which are degrees: a drag of one
/// point (CSS pixel) to the right is orbit_by(-DRAG_DEGREES_PER_POINT), one downwards is
/// tilt_by(+DRAG_DEGREES_PER_POINT), so that the tank follows the pointer. One notch of the wheel away from
/// the hand is zoom_by(+1).
constexpr double DRAG_DEGREES_PER_POINT = 0.3;

} // namespace app
