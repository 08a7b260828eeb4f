#include "particles/contact.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace particles {

namespace {

/// Nearer than this, in metres, a wall is touched: a little more than what rounding to float does nearby.
constexpr double TOUCHING_DISTANCE = 1e-6;

/// Slower than this, in m/s, nothing leaves a wall: more than what rounding leaves of a speed taken away.
constexpr double MIN_LEAVING_SPEED = 1e-9;

/// Less than this, in metres, is no way.
constexpr double ROUNDING = 1e-12;

double distance_to(const Wall& wall, const glm::dvec3& position)
{
    return glm::dot(wall.normal, position) - wall.offset;
}

bool is_touched(const Wall& wall, const glm::dvec3& position)
{
    return distance_to(wall, position) <= TOUCHING_DISTANCE;
}

/// Where slanted walls meet, leaving one may lead behind another, each time less far.
void put_inside(glm::dvec3& position, std::span<const Wall> walls)
{
    constexpr int MAX_ROUNDS = 64;
    bool is_inside = false;
    for (int round = 0; !is_inside && round < MAX_ROUNDS; ++round) {
        is_inside = true;
        for (const Wall& wall : walls) {
            const double distance = distance_to(wall, position);
            if (distance < 0.0) {
                position -= wall.normal * distance;
                is_inside = is_inside && distance > -ROUNDING;
            }
        }
    }
}

void bounce(glm::dvec3& velocity, const Wall& wall, double speed_towards)
{
    const double speed_away = speed_towards * wall.restitution;
    const bool rests = speed_away <= MIN_BOUNCE_SPEED;
    const double turned = speed_towards + (rests ? 0.0 : speed_away);
    glm::dvec3 along = velocity + wall.normal * speed_towards;
    const double speed_along = glm::length(along);
    const double lost = wall.friction * turned;
    along = lost < speed_along ? along * (1.0 - lost / speed_along) : glm::dvec3{0.0};
    velocity = rests ? along : along + wall.normal * speed_away;
}

/// Lets the particle react to the walls it touches and is moving or pressed towards.
Fate touch_walls(Motion& motion, const glm::dvec3& acceleration, std::span<const Wall> walls)
{
    for (const Wall& wall : walls) {
        if (!is_touched(wall, motion.position)) {
            continue;
        }
        const double speed = glm::dot(wall.normal, motion.velocity);
        const bool is_pressed = speed <= MIN_LEAVING_SPEED && glm::dot(wall.normal, acceleration) < 0.0;
        if (speed >= 0.0 && !is_pressed) {
            continue;
        }
        switch (wall.response) {
        case ContactResponse::recycle:
            return Fate::is_recycled;
        case ContactResponse::stick:
            motion.velocity = glm::dvec3{0.0};
            return Fate::sticks;
        case ContactResponse::bounce:
            if (speed < 0.0) {
                bounce(motion.velocity, wall, -speed);
            }
            break;
        }
    }
    return Fate::moves;
}

/// What pushes a particle that may rest on walls, and how long that holds.
struct Push
{
    glm::dvec3 acceleration{0.0};
    bool holds_still = false; ///< friction keeps it where it is
    double stops_after;       ///< seconds until it has slid to a stop
    glm::dvec3 sliding{0.0};  ///< the direction in which it does, length 1
};

constexpr double NEVER = 1e300;

/// The walls that a particle rests on push back just as much as keeps it from being pressed into any of them.
/// Where several do, their shares are found by projected Gauss-Seidel (Catto, Iterative Dynamics, 2005).
Push push_of(const Motion& motion, const Forces& forces, std::span<const Wall> walls)
{
    constexpr int MAX_ROUNDS = 64;
    Push push{.acceleration = forces.acceleration, .stops_after = NEVER};
    std::array<double, ParticleSettings::MAX_PLANES> shares{};
    bool is_settled = false;
    for (int round = 0; !is_settled && round < MAX_ROUNDS; ++round) {
        is_settled = true;
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const Wall& wall = walls[i];
            const double away = glm::dot(wall.normal, push.acceleration);
            if ((away >= 0.0 && shares[i] == 0.0) || !is_touched(wall, motion.position) ||
                glm::dot(wall.normal, motion.velocity) > MIN_LEAVING_SPEED) {
                continue;
            }
            const double change = std::max(-away, -shares[i]);
            shares[i] += change;
            push.acceleration += wall.normal * change;
            is_settled = is_settled && std::abs(change) <= ROUNDING * (1.0 + shares[i]);
        }
    }
    double friction = 0.0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        friction += walls[i].friction * shares[i];
    }
    if (friction == 0.0) {
        return push;
    }
    const double speed = glm::length(motion.velocity);
    const double pull = glm::length(push.acceleration);
    if (speed <= MIN_LEAVING_SPEED && pull <= friction) {
        push.holds_still = true;
        return push;
    }
    push.sliding = speed > MIN_LEAVING_SPEED ? motion.velocity / speed : push.acceleration / pull;
    push.acceleration -= push.sliding * friction;
    const double slowing = -glm::dot(push.sliding, push.acceleration);
    if (speed > MIN_LEAVING_SPEED && slowing > 0.0) {
        push.stops_after =
            time_of_reach(forces.air_resistance, speed / (forces.air_resistance * speed + slowing));
    }
    return push;
}

/// Finishes the flight if it is free of contacts from its beginning to its end: the usual case, at less cost.
bool fly_freely(Motion& motion, const Forces& forces, std::span<const Wall> walls, const Flight& whole)
{
    const Motion after = {
        motion.position + motion.velocity * whole.reach + forces.acceleration * whole.fall,
        motion.velocity * whole.keep + forces.acceleration * whole.reach,
    };
    for (const Wall& wall : walls) {
        const bool may_turn = glm::dot(wall.normal, forces.acceleration) > 0.0;
        if (is_touched(wall, motion.position) || is_touched(wall, after.position) ||
            (may_turn && glm::dot(wall.normal, motion.velocity) < 0.0 &&
             glm::dot(wall.normal, after.velocity) > 0.0)) {
            return false;
        }
    }
    motion = after;
    return true;
}

/// Returns the flight to the next contact, or the whole limit.
Flight flight_to_next_wall(const Motion& motion, const glm::dvec3& acceleration, double air_resistance,
                           std::span<const Wall> walls, const Flight& limit)
{
    Flight nearest = limit;
    for (const Wall& wall : walls) {
        const double distance = std::max(0.0, distance_to(wall, motion.position));
        const double speed = glm::dot(wall.normal, motion.velocity);
        if (distance <= TOUCHING_DISTANCE && speed <= MIN_LEAVING_SPEED) {
            if (speed < -MIN_LEAVING_SPEED) {
                return flight(air_resistance, 0.0); // another wall has just sent it here
            }
            continue; // rests on it, slides along it or is lifted off it
        }
        const auto time =
            time_of_contact(distance, speed, glm::dot(wall.normal, acceleration), air_resistance, nearest);
        if (time) {
            nearest = flight(air_resistance, *time);
        }
    }
    return nearest;
}

} // namespace

std::optional<double> time_of_contact(double distance, double speed, double acceleration,
                                      double air_resistance, const Flight& limit)
{
    const auto height = [=](const Flight& f) { return distance + speed * f.reach + acceleration * f.fall; };
    const auto slope = [=](const Flight& f) { return speed * f.keep + acceleration * f.reach; };

    // The second derivative of the height is (acceleration - air_resistance * speed) * keep: of one sign.
    const double bend = acceleration - air_resistance * speed;
    if (height(limit) >= 0.0) {
        // Only one that came near and turned round can have touched in between.
        if (bend <= 0.0 || speed >= 0.0 || slope(limit) <= 0.0) {
            return std::nullopt;
        }
        const double turn = time_of_reach(air_resistance, -speed / bend);
        if (height(flight(air_resistance, turn)) >= 0.0) {
            return std::nullopt;
        }
    }
    // Newton's method, from the side where the curve lies between its tangents and the axis: a bend away from
    // the plane is approached from its beginning, one towards it from the end. The times only go one way. A
    // step doubles the number of right digits, so that after a short one there is nothing left to do.
    constexpr int MAX_STEPS = 100;
    constexpr double SHORT_STEP = 1e-9;
    double time = bend > 0.0 ? 0.0 : limit.seconds;
    Flight so_far = bend > 0.0 ? flight(air_resistance, 0.0) : limit;
    for (int i = 0; i < MAX_STEPS; ++i) {
        const double next = std::clamp(time - height(so_far) / slope(so_far), 0.0, limit.seconds);
        const double step = bend > 0.0 ? next - time : time - next;
        if (!(step > 0.0)) {
            break;
        }
        time = next;
        if (step < SHORT_STEP) {
            break;
        }
        so_far = flight(air_resistance, time);
    }
    return time;
}

Wall wall_of(const CollisionPlane& plane)
{
    const glm::dvec3 normal = glm::dvec3{plane.normal} / glm::length(glm::dvec3{plane.normal});
    return {normal, glm::dot(normal, glm::dvec3{plane.point}), static_cast<double>(plane.restitution),
            static_cast<double>(plane.friction), plane.response};
}

Fate fly_among_walls(Motion& motion, const Forces& forces, std::span<const Wall> walls, const Flight& whole)
{
    if (fly_freely(motion, forces, walls, whole)) {
        return Fate::moves;
    }
    double seconds = whole.seconds;
    for (int contact = 0;; ++contact) {
        put_inside(motion.position, walls);
        const Fate fate = touch_walls(motion, forces.acceleration, walls);
        if (fate != Fate::moves || seconds <= 0.0 || contact == MAX_CONTACTS) {
            return fate;
        }
        const Push push = push_of(motion, forces, walls);
        if (push.holds_still) {
            motion.velocity = glm::dvec3{0.0};
            return Fate::moves;
        }
        const double until_stop = std::min(seconds, push.stops_after);
        const Flight limit = until_stop == whole.seconds ? whole : flight(forces.air_resistance, until_stop);
        const Flight part =
            flight_to_next_wall(motion, push.acceleration, forces.air_resistance, walls, limit);
        motion.position += motion.velocity * part.reach + push.acceleration * part.fall;
        motion.velocity = motion.velocity * part.keep + push.acceleration * part.reach;
        if (part.seconds == push.stops_after) {
            motion.velocity -= push.sliding * glm::dot(push.sliding, motion.velocity);
        }
        seconds -= part.seconds;
    }
}

} // namespace particles
