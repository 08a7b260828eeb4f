#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>

namespace particles {

/// The most places a system can have.
constexpr int MAX_PARTICLES = 1'000'000;

/// The most particles a second that a system can release by itself.
constexpr double MAX_RELEASE_RATE = 1e6;

/// The longest life of a particle, and the shortest and the longest release interval, in seconds.
constexpr double MAX_LIFE = 60.0;
constexpr double MIN_RELEASE_INTERVAL = 0.001;
constexpr double MAX_RELEASE_INTERVAL = 60.0;

/// Says what becomes of a particle that touches a plane.
enum class ContactResponse : std::uint8_t
{
    bounce,
    stick,   ///< stays where it touched until its life is over
    recycle, ///< its life is over, its place is free again
};

/// Describes a plane that particles do not pass. Metres.
struct CollisionPlane
{
    glm::vec3 normal{0.0f, 1.0f, 0.0f}; ///< to the side where the particles are; any length but 0
    glm::vec3 point{0.0f};              ///< any point of the plane
    ContactResponse response = ContactResponse::bounce;
    float restitution = 0.5f; ///< speed away from the plane / speed towards it; 0 to 1
    float friction = 0.0f;    ///< Coulomb's coefficient, when bouncing and when sliding; 0 to 10

    friend bool operator==(const CollisionPlane&, const CollisionPlane&) = default;
};

/// A colour over a particle's life: straight from start to middle, then to end.
/// Red, green, blue and alpha from 0 to 1, not premultiplied.
struct ColourRamp
{
    glm::vec4 start{1.0f};
    glm::vec4 middle{1.0f};
    glm::vec4 end{1.0f, 1.0f, 1.0f, 0.0f};
    float middle_at = 0.5f; ///< the part of the life after which the middle is reached; 0 to 1

    friend bool operator==(const ColourRamp&, const ColourRamp&) = default;
};

/// A particle's size over its life: a dot's diameter or a streak's width, in metres; straight in between.
struct SizeRamp
{
    float start = 0.1f;
    float end = 0.1f;

    friend bool operator==(const SizeRamp&, const SizeRamp&) = default;
};

/// Says what a particle looks like.
enum class TextureKind : std::uint8_t
{
    soft_dot, ///< round, facing the eye, fading towards its rim
    streak,   ///< along the way it came in the last `streak_time`, fading towards its sides
};

/// Says how a particle is blended with what is behind it.
enum class Blending : std::uint8_t
{
    additive, ///< glows; the order of drawing does not matter
    over,     ///< covers by its alpha
};

/// Holds all that can be set of a particle system. Metres, seconds; validate() says what is allowed.
struct ParticleSettings
{
    static constexpr std::size_t MAX_PLANES = 6;

    int maximum_particles = 100;    ///< how many places there are; 0: nothing is ever released
    int release_count = 1;          ///< released together at every release interval
    double release_interval = 0.05; ///< also the time within which a burst is released
    bool releases = true;           ///< releases by itself; otherwise only bursts

    double life = 1.0;          ///< how long a particle lives; 0: none is ever seen
    double life_variance = 0.0; ///< 0 to 1: lives are up to this part shorter, evenly distributed
    SizeRamp size;
    ColourRamp colour;
    TextureKind texture = TextureKind::soft_dot;
    Blending blending = Blending::additive;
    double streak_time = 0.03; ///< a streak is as long as the way of this time, or since the release

    glm::vec3 position{0.0f};
    glm::vec3 position_variance{0.0f}; ///< half the sides of the box around it in which particles begin
    glm::vec3 velocity{0.0f};
    double velocity_variance = 0.0; ///< radius of the ball around it in which velocities begin, m/s
    glm::vec3 gravity{0.0f};        ///< m/s^2
    glm::vec3 wind{0.0f};           ///< the velocity of the air; without effect when there is no resistance
    double air_resistance = 0.0;    ///< 1/s: dv/dt = gravity - air_resistance * (v - wind)

    std::array<CollisionPlane, MAX_PLANES> planes{};
    int plane_count = 0; ///< how many of them there are

    std::span<const CollisionPlane> used_planes() const
    {
        return {planes.data(), static_cast<std::size_t>(plane_count)};
    }

    friend bool operator==(const ParticleSettings&, const ParticleSettings&) = default;
};

/// Finds out whether a system can have these settings. Returns "", or a sentence that names the first setting
/// that cannot be, and what it can be. Not-a-number and infinity are never allowed.
std::string validate(const ParticleSettings& settings);

/// Tells whether a particle may begin there: within 10 km of the origin along each axis, at most 1000 m/s
/// along each axis. Not-a-number may not.
bool is_valid_source(const glm::vec3& position, const glm::vec3& velocity);

/// Returns the settings with the emitter and the planes moved by some metres.
ParticleSettings moved(ParticleSettings settings, const glm::vec3& by);

} // namespace particles
