#include "particles/move_all.h"

#include "particles/block_loops.h"
#include "particles/flight.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>

namespace particles {

namespace {

using ThreeQuantities = std::array<ParticleStore::Quantity, 3>;
constexpr ThreeQuantities POSITIONS{ParticleStore::x, ParticleStore::y, ParticleStore::z};
constexpr ThreeQuantities VELOCITIES{ParticleStore::velocity_x, ParticleStore::velocity_y,
                                     ParticleStore::velocity_z};

class BlockMover
{
public:
    BlockMover(ParticleStore& store, const Forces& forces, std::span<const Wall> walls, double seconds)
        : store_(store), forces_(forces), walls_(walls), whole_(flight(forces.air_resistance, seconds))
    {
        for (int axis = 0; axis < 3; ++axis) {
            const double acceleration = forces.acceleration[axis];
            axes_[static_cast<std::size_t>(axis)] = {static_cast<float>(whole_.keep),
                                                     static_cast<float>(whole_.reach),
                                                     static_cast<float>(acceleration * whole_.reach),
                                                     static_cast<float>(acceleration * whole_.fall)};
        }
    }

    void move(std::size_t begin, std::size_t count)
    {
        begin_ = begin;
        count_ = static_cast<int>(count);
        if (walls_.empty()) {
            fly();
            return;
        }
        fly_and_remember();
        if (mark_all_that_touch()) {
            for (std::size_t i = 0; i < count; ++i) {
                if (marks_[i] != 0) {
                    move_among_walls(i);
                }
            }
        }
    }

    bool has_recycled() const { return has_recycled_; }

private:
    using Values = std::array<float, BLOCK_SIZE>;

    float* values(ParticleStore::Quantity quantity) { return store_.array(quantity) + begin_; }

    Vectors now(const ThreeQuantities& axes) { return {values(axes[0]), values(axes[1]), values(axes[2])}; }

    void fly()
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            move_block(values(POSITIONS[axis]), values(VELOCITIES[axis]), count_, axes_[axis]);
        }
    }

    void fly_and_remember()
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            move_block(values(POSITIONS[axis]), values(VELOCITIES[axis]), old_positions_[axis].data(),
                       old_velocities_[axis].data(), count_, axes_[axis]);
        }
    }

    bool mark_all_that_touch()
    {
        bool adds = false; // to what was marked in the block before: no
        bool any = false;
        for (const Wall& wall : walls_) {
            const glm::vec3 normal{wall.normal};
            any |= mark_outside(now(POSITIONS), marks_.data(), count_, normal,
                                static_cast<float>(wall.offset), adds);
            adds = true;
            if (glm::dot(wall.normal, forces_.acceleration) > 0.0) {
                const Vectors before{old_velocities_[0].data(), old_velocities_[1].data(),
                                     old_velocities_[2].data()};
                any |= mark_turned(before, now(VELOCITIES), marks_.data(), count_, normal);
            }
        }
        return any;
    }

    void move_among_walls(std::size_t i)
    {
        const std::size_t place = begin_ + i;
        Motion motion{{old_positions_[0][i], old_positions_[1][i], old_positions_[2][i]},
                      {old_velocities_[0][i], old_velocities_[1][i], old_velocities_[2][i]}};
        const Fate fate = fly_among_walls(motion, forces_, walls_, whole_);
        Particle particle = store_.get(place);
        particle.position = motion.position;
        particle.velocity = motion.velocity;
        if (fate == Fate::is_recycled) {
            particle.age = particle.life;
            has_recycled_ = true;
        }
        store_.set(place, particle);
        if (fate == Fate::sticks) {
            // What comes here in its stead has been moved already.
            store_.stick(place);
        }
    }

    ParticleStore& store_;
    const Forces& forces_;
    std::span<const Wall> walls_;
    Flight whole_;
    std::array<AxisMotion, 3> axes_{};
    std::size_t begin_ = 0;
    int count_ = 0;
    std::array<Values, 3> old_positions_;
    std::array<Values, 3> old_velocities_;
    std::array<std::int32_t, BLOCK_SIZE> marks_{};
    bool has_recycled_ = false;
};

} // namespace

std::size_t move_all(ParticleStore& store, const Forces& forces, std::span<const Wall> walls, double seconds)
{
    BlockMover mover(store, forces, walls, seconds);
    const std::size_t end = store.live();
    for (std::size_t begin = store.stuck(); begin < end; begin += BLOCK_SIZE) {
        mover.move(begin, std::min(BLOCK_SIZE, end - begin));
    }
    return mover.has_recycled() ? store.age_all(0.0f) : 0;
}

} // namespace particles
