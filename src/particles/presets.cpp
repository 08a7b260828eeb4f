#include "particles/presets.h"

#include <array>
#include <cstddef>

namespace particles {

namespace {

constexpr float earth = -9.81F; // m/s^2

const ColourRamp fire{.start = {1.0F, 0.95F, 0.7F, 1.0F},
                      .middle = {1.0F, 0.45F, 0.1F, 0.8F},
                      .end = {0.35F, 0.05F, 0.02F, 0.0F},
                      .middle_at = 0.35F};

const ColourRamp water{.start = {0.85F, 0.93F, 1.0F, 0.8F},
                       .middle = {0.45F, 0.65F, 1.0F, 0.5F},
                       .end = {0.2F, 0.35F, 0.9F, 0.0F}};

const ColourRamp starlight{.start = {0.2F, 0.3F, 0.8F, 0.0F},
                           .middle = {0.9F, 0.9F, 1.0F, 0.9F},
                           .end = {0.6F, 0.2F, 0.7F, 0.0F},
                           .middle_at = 0.3F};

const ColourRamp paint_spot{.start = {0.95F, 0.75F, 0.1F, 1.0F},
                            .middle = {0.9F, 0.25F, 0.2F, 1.0F},
                            .end = {0.75F, 0.1F, 0.35F, 0.0F},
                            .middle_at = 0.6F};

// Steel: white-hot, then orange, dark when it goes out.
const ColourRamp hot_metal{.start = {1.0F, 0.98F, 0.9F, 1.0F},
                           .middle = {1.0F, 0.55F, 0.12F, 0.9F},
                           .end = {0.25F, 0.04F, 0.0F, 0.0F},
                           .middle_at = 0.35F};

const CollisionPlane ground{
    .normal = {0.0F, 1.0F, 0.0F}, .point = {0.0F, 0.0F, 0.0F}, .restitution = 0.45F, .friction = 0.3F};

constexpr CollisionPlane wall(glm::vec3 normal, glm::vec3 point)
{
    return {.normal = normal, .point = point, .restitution = 0.8F, .friction = 0.05F};
}

/// What sparks and their shower share.
ParticleSettings spark()
{
    return {.life = 0.5,
            .life_variance = 0.5,
            .size = {0.05F, 0.02F},
            .colour = hot_metal,
            .texture = TextureKind::streak,
            .blending = Blending::additive,
            .streak_time = 0.03,
            .gravity = {0.0F, earth, 0.0F},
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
    settings.size = {0.035F, 0.015F};
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
          .size = {0.5F, 0.2F},
          .colour = fire,
          .position = {0.0F, 4.0F, 0.0F},
          .velocity_variance = 10.0,
          .gravity = {0.0F, -2.0F, 0.0F},
          .air_resistance = 2.0}},
        {PresetName::fountain,
         "fountain",
         "Fountain blown by the wind",
         0,
         {.maximum_particles = 500,
          .release_count = 5,
          .life = 4.0,
          .size = {0.12F, 0.3F},
          .colour = water,
          .velocity = {0.0F, 9.0F, 0.0F},
          .velocity_variance = 1.5,
          .gravity = {0.0F, -4.0F, 0.0F},
          .wind = {2.0F, 0.0F, 0.0F},
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
          .size = {0.15F, 0.15F},
          .colour = starlight,
          .position = {0.0F, 4.0F, 0.0F},
          .velocity_variance = 2.0}},
        {PresetName::paint,
         "paint",
         "Paint blown against a wall, where it sticks",
         0,
         {.maximum_particles = 700,
          .release_count = 10,
          .life = 3.0,
          .size = {0.15F, 0.3F},
          .colour = paint_spot,
          .blending = Blending::over,
          .position = {0.0F, 1.5F, 0.0F},
          .velocity = {0.0F, 5.0F, 0.0F},
          .velocity_variance = 2.5,
          .wind = {0.0F, 0.0F, -20.0F},
          .air_resistance = 0.8,
          .planes = {CollisionPlane{.normal = {0.0F, 0.0F, 1.0F},
                                    .point = {0.0F, 0.0F, -5.0F},
                                    .response = ContactResponse::stick}},
          .plane_count = 1}},
        {PresetName::bounce,
         "bounce",
         "Fountain that bounces on the floor",
         0,
         {.maximum_particles = 1000,
          .release_count = 10,
          .life = 5.0,
          .size = {0.2F, 0.15F},
          .colour = fire,
          .position = {0.0F, 0.1F, 0.0F},
          .velocity = {0.0F, 9.0F, 0.0F},
          .velocity_variance = 3.0,
          .gravity = {0.0F, earth, 0.0F},
          .air_resistance = 0.1,
          .planes = {CollisionPlane{.restitution = 0.7F, .friction = 0.1F}},
          .plane_count = 1}},
        {PresetName::box,
         "box",
         "Fountain boxed in by six planes",
         0,
         {.maximum_particles = 500,
          .release_count = 5,
          .life = 5.0,
          .size = {0.2F, 0.15F},
          .colour = starlight,
          .position = {0.0F, 1.0F, 0.0F},
          .velocity = {0.0F, 6.0F, 0.0F},
          .velocity_variance = 8.0,
          .gravity = {0.0F, earth, 0.0F},
          .planes =
              {wall({0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 0.0F}), wall({0.0F, -1.0F, 0.0F}, {0.0F, 5.0F, 0.0F}),
               wall({1.0F, 0.0F, 0.0F}, {-3.0F, 0.0F, 0.0F}), wall({-1.0F, 0.0F, 0.0F}, {3.0F, 0.0F, 0.0F}),
               wall({0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, -3.0F}), wall({0.0F, 0.0F, -1.0F}, {0.0F, 0.0F, 3.0F})},
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

std::optional<PresetName> preset_from_id(std::string_view id)
{
    for (const Preset& preset : table()) {
        if (preset.id == id) {
            return preset.name;
        }
    }
    return std::nullopt;
}

} // namespace particles
