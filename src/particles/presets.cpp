#include "particles/presets.h"

#include <array>
#include <cstddef>

namespace particles {

namespace {

constexpr float EARTH_GRAVITY = -9.81f; // m/s^2

const ColourRamp fire{.start = {1.0f, 0.95f, 0.7f, 1.0f},
                      .middle = {1.0f, 0.45f, 0.1f, 0.8f},
                      .end = {0.35f, 0.05f, 0.02f, 0.0f},
                      .middle_at = 0.35f};

const ColourRamp water{.start = {0.85f, 0.93f, 1.0f, 0.8f},
                       .middle = {0.45f, 0.65f, 1.0f, 0.5f},
                       .end = {0.2f, 0.35f, 0.9f, 0.0f}};

const ColourRamp starlight{.start = {0.2f, 0.3f, 0.8f, 0.0f},
                           .middle = {0.9f, 0.9f, 1.0f, 0.9f},
                           .end = {0.6f, 0.2f, 0.7f, 0.0f},
                           .middle_at = 0.3f};

const ColourRamp paint_spot{.start = {0.95f, 0.75f, 0.1f, 1.0f},
                            .middle = {0.9f, 0.25f, 0.2f, 1.0f},
                            .end = {0.75f, 0.1f, 0.35f, 0.0f},
                            .middle_at = 0.6f};

// Steel: white-hot, then orange, dark when it goes out.
const ColourRamp hot_metal{.start = {1.0f, 0.98f, 0.9f, 1.0f},
                           .middle = {1.0f, 0.55f, 0.12f, 0.9f},
                           .end = {0.25f, 0.04f, 0.0f, 0.0f},
                           .middle_at = 0.35f};

const CollisionPlane ground{
    .normal = {0.0f, 1.0f, 0.0f}, .point = {0.0f, 0.0f, 0.0f}, .restitution = 0.45f, .friction = 0.3f};

constexpr CollisionPlane wall(glm::vec3 normal, glm::vec3 point)
{
    return {.normal = normal, .point = point, .restitution = 0.8f, .friction = 0.05f};
}

/// What sparks and their shower share.
ParticleSettings spark()
{
    return {.life = 0.5,
            .life_variance = 0.5,
            .size = {0.05f, 0.02f},
            .colour = hot_metal,
            .texture = TextureKind::streak,
            .blending = Blending::additive,
            .streak_time = 0.03,
            .gravity = {0.0f, EARTH_GRAVITY, 0.0f},
            .air_resistance = 1.5,
            .planes = {ground},
            .plane_count = 1};
}

// Lab 2's: 100 particles within 0.05 s, which live 0.5 s, velocity variance 10. Places for six bursts.
ParticleSettings sparks()
{
    ParticleSettings settings = spark();
    settings.maximum_particles = 600;
    settings.release_count = 100;
    settings.release_interval = 0.05;
    settings.releases = false;
    settings.velocity_variance = 10.0;
    return settings;
}

ParticleSettings shower()
{
    ParticleSettings settings = spark();
    settings.maximum_particles = 64;
    settings.release_count = 3;
    settings.release_interval = 0.04;
    settings.size = {0.035f, 0.015f};
    settings.velocity_variance = 3.5;
    return settings;
}

std::array<Preset, 8> make_table()
{
    return {{
        {PresetName::explosion,
         "explosion",
         "Exploding burst",
         0,
         {.maximum_particles = 400,
          .release_count = 200,
          .release_interval = 1.5,
          .life = 1.2,
          .life_variance = 0.4,
          .size = {0.5f, 0.2f},
          .colour = fire,
          .position = {0.0f, 4.0f, 0.0f},
          .velocity_variance = 10.0,
          .gravity = {0.0f, -2.0f, 0.0f},
          .air_resistance = 2.0}},
        {PresetName::fountain,
         "fountain",
         "Fountain blown by the wind",
         0,
         {.maximum_particles = 500,
          .release_count = 5,
          .life = 4.0,
          .size = {0.12f, 0.3f},
          .colour = water,
          .velocity = {0.0f, 9.0f, 0.0f},
          .velocity_variance = 1.5,
          .gravity = {0.0f, -4.0f, 0.0f},
          .wind = {2.0f, 0.0f, 0.0f},
          .air_resistance = 0.5,
          .planes = {CollisionPlane{.response = ContactResponse::recycle}},
          .plane_count = 1}},
        {PresetName::space,
         "space",
         "All ways into empty space, without air",
         0,
         {.maximum_particles = 2048,
          .release_count = 10,
          .life = 5.0,
          .size = {0.15f, 0.15f},
          .colour = starlight,
          .position = {0.0f, 4.0f, 0.0f},
          .velocity_variance = 2.0}},
        {PresetName::paint,
         "paint",
         "Paint blown against a wall, where it sticks",
         0,
         {.maximum_particles = 700,
          .release_count = 10,
          .life = 3.0,
          .size = {0.15f, 0.3f},
          .colour = paint_spot,
          .blending = Blending::over,
          .position = {0.0f, 1.5f, 0.0f},
          .velocity = {0.0f, 5.0f, 0.0f},
          .velocity_variance = 2.5,
          .wind = {0.0f, 0.0f, -20.0f},
          .air_resistance = 0.8,
          .planes = {CollisionPlane{.normal = {0.0f, 0.0f, 1.0f},
                                    .point = {0.0f, 0.0f, -5.0f},
                                    .response = ContactResponse::stick}},
          .plane_count = 1}},
        {PresetName::bounce,
         "bounce",
         "Fountain that bounces on the floor",
         0,
         {.maximum_particles = 1000,
          .release_count = 10,
          .life = 5.0,
          .size = {0.2f, 0.15f},
          .colour = fire,
          .position = {0.0f, 0.1f, 0.0f},
          .velocity = {0.0f, 9.0f, 0.0f},
          .velocity_variance = 3.0,
          .gravity = {0.0f, EARTH_GRAVITY, 0.0f},
          .air_resistance = 0.1,
          .planes = {CollisionPlane{.restitution = 0.7f, .friction = 0.1f}},
          .plane_count = 1}},
        {PresetName::box,
         "box",
         "Fountain boxed in by six planes",
         0,
         {.maximum_particles = 500,
          .release_count = 5,
          .life = 5.0,
          .size = {0.2f, 0.15f},
          .colour = starlight,
          .position = {0.0f, 1.0f, 0.0f},
          .velocity = {0.0f, 6.0f, 0.0f},
          .velocity_variance = 8.0,
          .gravity = {0.0f, EARTH_GRAVITY, 0.0f},
          .planes =
              {wall({0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f}), wall({0.0f, -1.0f, 0.0f}, {0.0f, 5.0f, 0.0f}),
               wall({1.0f, 0.0f, 0.0f}, {-3.0f, 0.0f, 0.0f}), wall({-1.0f, 0.0f, 0.0f}, {3.0f, 0.0f, 0.0f}),
               wall({0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, -3.0f}), wall({0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, 3.0f})},
          .plane_count = 6}},
        {PresetName::sparks, "sparks", "Sparks of a hit", 100, sparks()},
        {PresetName::shower, "shower", "Shower of sparks while the projectile is inside", 0, shower()},
    }};
}

const std::array<Preset, 8>& table()
{
    static const std::array<Preset, 8> presets = make_table();
    return presets;
}

} // namespace

std::span<const Preset> presets()
{
    return table();
}

const Preset& preset(PresetName name)
{
    return table()[static_cast<std::size_t>(name)];
}

} // namespace particles
