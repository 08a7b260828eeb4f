#include "particles/settings.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <string_view>

namespace particles {

namespace {

constexpr double MAX_DISTANCE = 10'000.0;
constexpr double MAX_SPEED = 1'000.0;

/// False for not-a-number, too.
template <class Number> bool is_between(Number value, double minimum, double maximum)
{
    return static_cast<double>(value) >= minimum && static_cast<double>(value) <= maximum;
}

bool is_within(const glm::vec3& vector, double limit)
{
    return is_between(vector.x, -limit, limit) && is_between(vector.y, -limit, limit) &&
           is_between(vector.z, -limit, limit);
}

bool is_colour(const glm::vec4& colour)
{
    return is_between(colour.r, 0.0, 1.0) && is_between(colour.g, 0.0, 1.0) &&
           is_between(colour.b, 0.0, 1.0) && is_between(colour.a, 0.0, 1.0);
}

bool is_box(const glm::vec3& half_sides)
{
    return is_within(half_sides, MAX_DISTANCE) && half_sides.x >= 0.0f && half_sides.y >= 0.0f &&
           half_sides.z >= 0.0f;
}

/// A setting: what is allowed, in a test and in words. The sentence is "The " + name + " must be " + allowed.
struct Rule
{
    bool (*is_kept)(const ParticleSettings&);
    std::string_view name;
    std::string_view allowed;
};

constexpr Rule RULES[] = {
    {[](const ParticleSettings& s) {
         return s.maximum_particles >= 0 && s.maximum_particles <= MAX_PARTICLES;
     },
     "maximum of particles", "from 0 to 1000000"},
    {[](const ParticleSettings& s) { return s.release_count >= 0 && s.release_count <= MAX_PARTICLES; },
     "number to release", "from 0 to 1000000"},
    {[](const ParticleSettings& s) {
         return is_between(s.release_interval, MIN_RELEASE_INTERVAL, MAX_RELEASE_INTERVAL);
     },
     "release interval", "from 0.001 to 60 seconds"},
    {[](const ParticleSettings& s) { return s.release_count <= MAX_RELEASE_RATE * s.release_interval; },
     "number to release", "at most 1000000 a second, so smaller or at longer intervals"},
    {[](const ParticleSettings& s) { return is_between(s.life, 0.0, MAX_LIFE); }, "life cycle",
     "from 0 to 60 seconds"},
    {[](const ParticleSettings& s) { return is_between(s.life_variance, 0.0, 1.0); },
     "variance of the life cycle", "from 0 to 1"},
    {[](const ParticleSettings& s) {
         return is_between(s.size.start, 0.0, 100.0) && is_between(s.size.end, 0.0, 100.0);
     },
     "size", "from 0 to 100 metres, at the start and at the end"},
    {[](const ParticleSettings& s) {
         return is_colour(s.colour.start) && is_colour(s.colour.middle) && is_colour(s.colour.end);
     },
     "colour", "from 0 to 1 in red, green, blue and alpha, at the start, in the middle and at the end"},
    {[](const ParticleSettings& s) { return is_between(s.colour.middle_at, 0.0, 1.0); },
     "middle of the colour", "from 0 to 1 of the life cycle"},
    {[](const ParticleSettings& s) { return is_between(s.streak_time, 0.0, 10.0); }, "time of a streak",
     "from 0 to 10 seconds"},
    {[](const ParticleSettings& s) { return is_within(s.position, MAX_DISTANCE); }, "position",
     "from -10000 to 10000 metres along each axis"},
    {[](const ParticleSettings& s) { return is_box(s.position_variance); }, "variance of the position",
     "from 0 to 10000 metres along each axis"},
    {[](const ParticleSettings& s) { return is_within(s.velocity, MAX_SPEED); }, "velocity",
     "from -1000 to 1000 m/s along each axis"},
    {[](const ParticleSettings& s) { return is_between(s.velocity_variance, 0.0, MAX_SPEED); },
     "variance of the velocity", "from 0 to 1000 m/s"},
    {[](const ParticleSettings& s) { return is_within(s.gravity, 1000.0); }, "gravity",
     "from -1000 to 1000 m/s^2 along each axis"},
    {[](const ParticleSettings& s) { return is_within(s.wind, MAX_SPEED); }, "wind",
     "from -1000 to 1000 m/s along each axis"},
    {[](const ParticleSettings& s) { return is_between(s.air_resistance, 0.0, 1000.0); }, "air resistance",
     "from 0 to 1000 per second"},
    {[](const ParticleSettings& s) {
         return s.plane_count >= 0 && s.plane_count <= static_cast<int>(ParticleSettings::MAX_PLANES);
     },
     "number of collision planes", "from 0 to 6"},
};

/// The same for each of the collision planes.
struct PlaneRule
{
    bool (*is_kept)(const CollisionPlane&);
    std::string_view name;
    std::string_view allowed;
};

constexpr PlaneRule PLANE_RULES[] = {
    {[](const CollisionPlane& plane) {
         // Its square must neither vanish nor overflow when the normal is brought to length 1.
         return is_within(plane.normal, 1000.0) &&
                glm::dot(glm::dvec3{plane.normal}, glm::dvec3{plane.normal}) >= 1e-6;
     },
     "normal of a collision plane", "between 0.001 and 1000 long"},
    {[](const CollisionPlane& plane) { return is_within(plane.point, MAX_DISTANCE); },
     "point of a collision plane", "from -10000 to 10000 metres along each axis"},
    {[](const CollisionPlane& plane) { return is_between(plane.restitution, 0.0, 1.0); },
     "restitution of a collision plane", "from 0 to 1"},
    {[](const CollisionPlane& plane) { return is_between(plane.friction, 0.0, 10.0); },
     "friction of a collision plane", "from 0 to 10"},
};

std::string sentence(std::string_view name, std::string_view allowed)
{
    return std::string("The ").append(name).append(" must be ").append(allowed).append(".");
}

} // namespace

std::string validate(const ParticleSettings& settings)
{
    for (const Rule& rule : RULES) {
        if (!rule.is_kept(settings)) {
            return sentence(rule.name, rule.allowed);
        }
    }
    for (const CollisionPlane& plane : settings.used_planes()) {
        for (const PlaneRule& rule : PLANE_RULES) {
            if (!rule.is_kept(plane)) {
                return sentence(rule.name, rule.allowed);
            }
        }
    }
    return "";
}

bool is_valid_source(const glm::vec3& position, const glm::vec3& velocity)
{
    return is_within(position, MAX_DISTANCE) && is_within(velocity, MAX_SPEED);
}

ParticleSettings moved(ParticleSettings settings, const glm::vec3& by)
{
    settings.position += by;
    for (CollisionPlane& plane : settings.planes) {
        plane.point += by;
    }
    return settings;
}

} // namespace particles
