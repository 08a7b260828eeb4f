#include "particles/particle_store.h"

#include "particles/block_loops.h"

#include <algorithm>
#include <utility>

namespace particles {

void ParticleStore::set_capacity(std::size_t places)
{
    if (places == capacity_) {
        return;
    }
    const std::size_t kept = std::min(live_, places);
    std::vector<float> storage(places * QUANTITY_COUNT);
    for (std::size_t i = 0; i < QUANTITY_COUNT; ++i) {
        std::copy_n(array(static_cast<Quantity>(i)), kept, storage.data() + i * places);
    }
    storage_ = std::move(storage);
    capacity_ = places;
    live_ = kept;
    stuck_ = std::min(stuck_, kept);
}

Particle ParticleStore::get(std::size_t place) const
{
    return {{array(x)[place], array(y)[place], array(z)[place]},
            {array(velocity_x)[place], array(velocity_y)[place], array(velocity_z)[place]},
            array(age)[place],
            array(life)[place]};
}

void ParticleStore::set(std::size_t place, const Particle& particle)
{
    array(x)[place] = particle.position.x;
    array(y)[place] = particle.position.y;
    array(z)[place] = particle.position.z;
    array(velocity_x)[place] = particle.velocity.x;
    array(velocity_y)[place] = particle.velocity.y;
    array(velocity_z)[place] = particle.velocity.z;
    array(age)[place] = particle.age;
    array(life)[place] = particle.life;
}

void ParticleStore::append(const Particle& particle)
{
    set(live_++, particle);
}

void ParticleStore::stick(std::size_t place)
{
    const Particle particle = get(place);
    copy(stuck_, place);
    set(stuck_++, particle);
}

void ParticleStore::remove(std::size_t place)
{
    if (place < stuck_) {
        copy(--stuck_, place);
        place = stuck_;
    }
    copy(--live_, place);
}

std::size_t ParticleStore::age_all(float seconds)
{
    // From the back to the front: what fills a gap has been looked at already.
    const std::size_t before = live_;
    float* const ages = array(age);
    const float* const lives = array(life);
    for (std::size_t end = before; end > 0;) {
        const std::size_t begin = (end - 1) / BLOCK_SIZE * BLOCK_SIZE;
        if (age_block(ages + begin, lives + begin, static_cast<int>(end - begin), seconds)) {
            for (std::size_t place = end; place-- > begin;) {
                if (ages[place] >= lives[place]) {
                    remove(place);
                }
            }
        }
        end = begin;
    }
    return before - live_;
}

void ParticleStore::clear()
{
    live_ = 0;
    stuck_ = 0;
}

bool operator==(const ParticleStore& a, const ParticleStore& b)
{
    if (a.capacity_ != b.capacity_ || a.live_ != b.live_ || a.stuck_ != b.stuck_) {
        return false;
    }
    for (std::size_t i = 0; i < ParticleStore::QUANTITY_COUNT; ++i) {
        const auto quantity = static_cast<ParticleStore::Quantity>(i);
        if (!std::equal(a.array(quantity), a.array(quantity) + a.live_, b.array(quantity))) {
            return false;
        }
    }
    return true;
}

void ParticleStore::copy(std::size_t from, std::size_t to)
{
    float* values = storage_.data();
    const std::size_t next = capacity_;
    for (std::size_t i = 0; i < QUANTITY_COUNT; ++i, values += next) {
        values[to] = values[from];
    }
}

} // namespace particles
