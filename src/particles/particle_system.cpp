#include "particles/particle_system.h"

#include "particles/move_all.h"
#include "particles/random.h"

#include <algorithm>
#include <limits>

namespace particles {

ParticleSystem::ParticleSystem()
{
    settings_.maximum_particles = 0;
    colours_ = colour_table(settings_.colour);
}

std::string ParticleSystem::configure(const ParticleSettings& settings)
{
    std::string fault = validate(settings);
    if (!fault.empty()) {
        return fault;
    }
    const bool begins = settings.releases && !settings_.releases;
    settings_ = settings;
    colours_ = colour_table(settings.colour);
    const std::span<const CollisionPlane> planes = settings.used_planes();
    walls_ = {};
    std::transform(planes.begin(), planes.end(), walls_.begin(), wall_of);
    emitter_.set_until_release_at_most(begins ? 0.0 : settings.release_interval);
    const std::size_t before = store_.live();
    store_.set_capacity(static_cast<std::size_t>(settings.maximum_particles));
    counts_.ended += before - store_.live();
    return fault;
}

void ParticleSystem::restart(std::uint64_t seed)
{
    seed_ = seed;
    emitter_ = {};
    counts_ = {};
    store_.clear();
}

bool ParticleSystem::step(double seconds)
{
    if (!(seconds >= 0.0 && seconds <= std::numeric_limits<double>::max())) {
        return false;
    }
    seconds = std::min(seconds, MAX_LIFE);
    counts_.ended += store_.age_all(static_cast<float>(seconds));
    counts_.ended += move_all(store_, forces(), walls(), seconds);
    emitter_.advance(settings_, seconds, [this](const Release& due) { release(due); });
    return true;
}

bool ParticleSystem::burst(int count, const glm::vec3& position, const glm::vec3& velocity)
{
    if (count < 0 || !is_valid_source(position, velocity)) {
        return false;
    }
    if (count > 0) {
        emitter_.begin({{position, velocity}, count, 0, settings_.release_interval, 0.0},
                       [this](const Release& rest) { release(rest); });
    }
    return true;
}

bool ParticleSystem::set_source(const glm::vec3& position, const glm::vec3& velocity)
{
    if (!is_valid_source(position, velocity)) {
        return false;
    }
    settings_.position = position;
    settings_.velocity = velocity;
    return true;
}

void ParticleSystem::set_releasing(bool releases)
{
    if (releases && !settings_.releases) {
        emitter_.set_until_release_at_most(0.0);
    }
    settings_.releases = releases;
}

bool ParticleSystem::is_active() const
{
    return store_.live() > 0 || !emitter_.bursts().empty() ||
           (settings_.releases && settings_.release_count > 0 && capacity() > 0 && settings_.life > 0.0);
}

ParticleView ParticleSystem::view() const
{
    using Store = ParticleStore;
    return {store_.values(Store::x),
            store_.values(Store::y),
            store_.values(Store::z),
            store_.values(Store::velocity_x),
            store_.values(Store::velocity_y),
            store_.values(Store::velocity_z),
            store_.values(Store::age),
            store_.values(Store::life),
            colours_,
            settings_.size,
            settings_.texture,
            settings_.blending,
            static_cast<float>(settings_.streak_time)};
}

void ParticleSystem::release(const Release& release)
{
    const auto age = static_cast<float>(release.age);
    const Forces pushing = forces();
    const Flight whole = flight(pushing.air_resistance, release.age);
    for (int i = 0; i < release.count; ++i) {
        if (store_.is_full()) {
            counts_.refused += static_cast<std::uint64_t>(release.count - i);
            return;
        }
        Random random(seed_, counts_.released + counts_.refused);
        ++counts_.released;
        const auto life =
            static_cast<float>(settings_.life * (1.0 - settings_.life_variance * random.uniform()));
        if (age >= life) {
            ++counts_.ended;
            continue;
        }
        Motion motion{glm::dvec3{release.source.position}, glm::dvec3{release.source.velocity}};
        motion.velocity += random.in_ball() * settings_.velocity_variance;
        if (settings_.position_variance != glm::vec3{0.0f}) {
            motion.position += random.in_cube() * glm::dvec3{settings_.position_variance};
        }
        const Fate fate = fly_among_walls(motion, pushing, walls(), whole);
        if (fate == Fate::is_recycled) {
            ++counts_.ended;
            continue;
        }
        store_.append({motion.position, motion.velocity, age, life});
        if (fate == Fate::sticks) {
            store_.stick(store_.live() - 1);
        }
    }
}

Forces ParticleSystem::forces() const
{
    return {glm::dvec3{settings_.gravity} + glm::dvec3{settings_.wind} * settings_.air_resistance,
            settings_.air_resistance};
}

std::span<const Wall> ParticleSystem::walls() const
{
    return {walls_.data(), static_cast<std::size_t>(settings_.plane_count)};
}

} // namespace particles
