#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>

namespace app {

/// Says what is tested against the spheres of the tank.
enum class Probe : std::uint8_t
{
    none,
    point,
    segment, ///< from end A to end B; of no length it is a point
    ray,     ///< from end A through end B and on
    line,    ///< through both ends, without ends of its own
};

/// Says what the keys for the projectile move.
enum class Handle : std::uint8_t
{
    point,
    line_a,
    line_b,
};

/// Holds the projectile at rest, the line it can be fired along, and what of both is tested. Metres, in the
/// world.
struct Projectile
{
    glm::dvec3 point{0.0};
    double radius = 0.0; ///< 0 tests a point
    glm::dvec3 a{0.0};   ///< where it flies from
    glm::dvec3 b{0.0};   ///< what it flies through
    double speed = 0.0;  ///< m/s, when fired
    glm::dvec2 aim{0.0}; ///< a place in the window, from its middle to the right and up, in heights of what
                         ///< CameraView::field_of_view spans; commands that use it put it back to the middle
    Probe probe = Probe::none;
    Handle handle = Handle::point;

    friend bool operator==(const Projectile&, const Projectile&) = default;
};

/// Holds the projectile in flight: straight on, through everything, until it leaves what links can describe.
struct Shot
{
    bool flies = false;
    glm::dvec3 origin{0.0};   ///< metres
    glm::dvec3 velocity{0.0}; ///< m/s
    std::uint32_t age = 0;    ///< ticks since it was fired; of one that has ended, at its end

    friend bool operator==(const Shot&, const Shot&) = default;
};

/// Says what an animation began with.
enum class EventKind : std::uint8_t
{
    none,
    open, ///< the opening of the link
    fire,
};

/// Returns "none", "open" or "fire".
constexpr std::string_view event_name(EventKind kind)
{
    return kind == EventKind::open ? "open" : kind == EventKind::fire ? "fire" : "none";
}

/// Holds the animation that a link can replay: it began with this event, in the state's fields as they are.
/// When one of these that matters to it changes, it cannot be replayed any more and there is none.
struct Event
{
    EventKind kind = EventKind::none;
    std::uint32_t age = 0; ///< ticks since; at most MAX_REPLAY_TICKS

    friend bool operator==(const Event&, const Event&) = default;
};

/// A link replays at most this many ticks: a minute.
constexpr std::uint32_t MAX_REPLAY_TICKS = 3600;

} // namespace app
