#pragma once

#include "particles/flight.h"
#include "particles/settings.h"

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

namespace particles {

/// Returns the first time within `limit` at which what flies above a plane touches it, to the last few bits;
/// nothing if it does not. Exact flight (see Flight) along the plane's normal; metres, seconds.
/// distance: to the plane, >= 0; speed: away from it; at distance 0 precondition: > 0, that time 0 is no
/// touch. acceleration: away from the plane. limit: of the same air resistance.
std::optional<double> time_of_contact(double distance, double speed, double acceleration,
                                      double air_resistance, const Flight& limit);

/// A plane with its normal brought to length 1; the particles are where dot(normal, p) >= offset.
struct Wall
{
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double offset = 0.0;
    double restitution = 0.0;
    double friction = 0.0;
    ContactResponse response = ContactResponse::bounce;

    friend bool operator==(const Wall&, const Wall&) = default;
};

/// Returns the wall of a plane. Precondition: validate() has nothing against it.
Wall wall_of(const CollisionPlane& plane);

/// What pushes a particle: dv/dt = acceleration - air_resistance * v, wind being part of the acceleration.
struct Forces
{
    glm::dvec3 acceleration{0.0};
    double air_resistance = 0.0;
};

/// Where a particle is and how fast. Metres, m/s.
struct Motion
{
    glm::dvec3 position;
    glm::dvec3 velocity;
};

/// What became of a particle.
enum class Fate
{
    moves,
    sticks,      ///< at the position reached, with velocity 0
    is_recycled, ///< at the position reached
};

/// Slower than this, in m/s, nothing bounces off a wall.
constexpr double MIN_BOUNCE_SPEED = 0.05;

/// After so many contacts in one flight the particle stays where it is for the rest of that time.
constexpr int MAX_CONTACTS = 16;

/// Moves a particle for a time among walls, touching each at its time.
/// - Between contacts it flies exactly, so that one long flight is as good as many short ones.
/// - A bounce turns the speed towards the wall round, times the restitution, and takes friction * (1 +
///   restitution) times that speed from the speed along the wall, at most all of it (Coulomb).
/// - Slower than MIN_BOUNCE_SPEED it does not bounce but rests on the wall: it slides, against Coulomb
///   friction, while the forces press it there. Pushed sideways while it slides, it keeps the direction of
///   friction that it has at the beginning of the flight.
/// - The energy of its motion never grows by a contact.
/// - One that is behind a wall is first put on it, so that nothing is ever behind one afterwards, but for
///   rounding. Where walls leave no room in between, it is behind one of them.
/// whole: the time, of the same air resistance; callers have it for many particles.
/// Precondition: at most ParticleSettings::MAX_PLANES walls.
Fate fly_among_walls(Motion& motion, const Forces& forces, std::span<const Wall> walls, const Flight& whole);

} // namespace particles
