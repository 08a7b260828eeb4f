#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace particles {

/// One particle, for putting in and taking out. Metres, seconds.
struct Particle
{
    glm::vec3 position;
    glm::vec3 velocity;
    float age;
    float life; ///< the age at which it is over
};

/// Holds the living particles of a system without gaps, each quantity in its own array, so that a loop over
/// them works on four at a time. First those that are stuck, then those that move. The place of one that is
/// taken out is filled by the last, so their order changes.
class ParticleStore
{
public:
    /// Names the arrays.
    enum Quantity : std::size_t
    {
        x,
        y,
        z,
        velocity_x,
        velocity_y,
        velocity_z,
        age,
        life,
    };
    static constexpr std::size_t QUANTITY_COUNT = 8;

    /// Changes the number of places; the only function that allocates. Those who find no place are dropped.
    void set_capacity(std::size_t places);

    std::size_t capacity() const { return capacity_; }
    std::size_t live() const { return live_; }
    std::size_t stuck() const { return stuck_; }
    bool is_full() const { return live_ == capacity_; }

    /// Returns the values of the living, in the order of their places.
    std::span<const float> values(Quantity quantity) const { return {array(quantity), live_}; }

    /// Returns the first value of an array that has a value for each living.
    float* array(Quantity quantity) { return storage_.data() + quantity * capacity_; }
    const float* array(Quantity quantity) const { return storage_.data() + quantity * capacity_; }

    Particle get(std::size_t place) const;
    void set(std::size_t place, const Particle& particle);

    /// Puts a particle at the end of those that move, at place live() - 1. Precondition: it is not full.
    void append(const Particle& particle);

    /// Puts a particle that moves among those that are stuck; another takes its place.
    /// Precondition: stuck() <= place < live().
    void stick(std::size_t place);

    /// Takes one out. Precondition: place < live(). All that are behind it may change their places.
    void remove(std::size_t place);

    /// Lets all grow older by some seconds and takes out those whose age has reached their life.
    /// Returns how many.
    std::size_t age_all(float seconds);

    /// Takes all out.
    void clear();

    /// True when both have as many places and the same living at the same places.
    friend bool operator==(const ParticleStore& a, const ParticleStore& b);

private:
    void copy(std::size_t from, std::size_t to);

    std::vector<float> storage_; ///< one array after the other, capacity_ values each
    std::size_t capacity_ = 0;
    std::size_t live_ = 0;
    std::size_t stuck_ = 0;
};

} // namespace particles
