#pragma once

#include "app/state/projectile.h"
#include "app/state/show.h"
#include "tank/joint.h"

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace app {

/// Says from where the tank is seen.
enum class View : std::uint8_t
{
    orbit,  ///< from anywhere around it
    follow, ///< from behind, swinging round with its heading
    gunner, ///< through the main gun's sight, along its barrel
    four,   ///< from the front, the side and above, from far away, and as `orbit` has it
};

/// Holds where the eye is. Angles in radians, lengths in metres.
/// orbit: 0 has the eye in front of the tank at rest, looking along -Z as the lab's own camera does; positive
///        goes anticlockwise seen from above, to the tank's left (+X) first.
/// tilt: 0 is level with the point looked at, positive is above it.
/// distance: from the eye to the point looked at. How much the gunner's sight shows goes by it, too.
/// look: the point looked at, from the tank's position; it follows the tank but turns with it only in
/// `follow`. chase: how far the eye is from behind the tank in `follow`; positive as in orbit. It goes back
/// to 0 by itself.
struct Camera
{
    View view = View::orbit;
    double orbit = 0.0;
    double tilt = 0.0;
    double distance = 0.0;
    glm::dvec3 look{0.0};
    double chase = 0.0;

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Says which particles are shown besides the sparks of hits.
struct ParticleShow
{
    std::uint8_t preset = 0; ///< 0: none, otherwise one more than the row of particles::presets()
    std::int32_t amount = 0; ///< how many places there are

    friend bool operator==(const ParticleShow&, const ParticleShow&) = default;
};

/// At most this many rows of the table of commands can be held.
constexpr std::size_t MAX_HELD_COMMANDS = 128;

/// Seeds are from 1 to this; a firing takes the next one.
constexpr std::uint64_t FIRST_SEED = 1;
constexpr std::uint64_t LAST_SEED = 999'999;

/// Says whose tank is shown: the program's, or the one that the user brought. As long as there is none, the
/// program's takes its place.
enum class TankShown : std::uint8_t
{
    lab,
    own,
};

/// Holds everything that can change while the program runs, as plain data: copy it, compare it, hash it.
/// Only apply(), step() and open_link() change one that is in use, and they say what has
/// changed: see Outcome.
struct State
{
    tank::JointAngles joints; ///< within tank::joint_limits
    double x = 0.0;           ///< the tank's position on the ground, metres
    double z = 0.0;
    TankShown tank = TankShown::lab;
    Camera camera;
    Projectile projectile;
    Show show;
    ParticleShow particles;
    Shot shot;
    Event event;
    std::optional<std::size_t> task;     ///< the row of tasks() that the state was opened with
    std::bitset<MAX_HELD_COMMANDS> held; ///< by row of commands()
    std::uint64_t tick = 0;              ///< steps of 1/60 s since the state was opened
    std::uint64_t seed = FIRST_SEED;     ///< of the random numbers since the event

    /// Makes the state that an empty link describes: every field has its default from the table of fields.
    State();

    friend bool operator==(const State&, const State&) = default;
};

/// Returns the state as bytes, the same on every machine: the fields in the table's order, then the rest.
/// Equal states have equal bytes.
std::string serialised(const State& state);

/// Returns the 64-bit FNV-1a hash of serialised(state).
std::uint64_t hash(const State& state);

} // namespace app
