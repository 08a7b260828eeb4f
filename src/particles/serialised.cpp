#include "particles/particle_system.h"

namespace particles {

namespace {

template <class Take> void write(Take& take, std::uint64_t value, int bytes = 8)
{
    for (int i = 0; i < bytes; ++i) {
        take(static_cast<unsigned char>((value >> (8 * i)) & 0xff));
    }
}

// -0 equals 0, so both are written as 0.
template <class Take> void write(Take& take, float value)
{
    write(take, __builtin_bit_cast(std::uint32_t, value == 0.0f ? 0.0f : value), 4);
}

template <class Take> void write(Take& take, double value)
{
    write(take, __builtin_bit_cast(std::uint64_t, value == 0.0 ? 0.0 : value));
}

template <class Take> void write(Take& take, const Source& source)
{
    for (const glm::vec3& vector : {source.position, source.velocity}) {
        for (int axis = 0; axis < 3; ++axis) {
            write(take, vector[axis]);
        }
    }
}

/// Hands the bytes to take(unsigned char), little end first.
template <class Take> void write(Take& take, const ParticleSystem& system)
{
    write(take, system.seed());
    write(take, system.counts().released);
    write(take, system.counts().ended);
    write(take, system.counts().refused);
    write(take, system.emitter().until_release());
    for (const Burst& burst : system.emitter().bursts()) {
        write(take, burst.source);
        write(take, static_cast<std::uint64_t>(burst.count));
        write(take, static_cast<std::uint64_t>(burst.released));
        write(take, burst.duration);
        write(take, burst.elapsed);
    }
    const ParticleView view = system.view();
    write(take, static_cast<std::uint64_t>(view.count()));
    for (const std::span<const float> values :
         {view.x, view.y, view.z, view.velocity_x, view.velocity_y, view.velocity_z, view.age, view.life}) {
        for (const float value : values) {
            write(take, value);
        }
    }
}

} // namespace

std::string serialised(const ParticleSystem& system)
{
    std::string bytes;
    const auto append = [&bytes](unsigned char byte) { bytes.push_back(static_cast<char>(byte)); };
    write(append, system);
    return bytes;
}

std::uint64_t hash(const ParticleSystem& system)
{
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto add = [&hash](unsigned char byte) { hash = (hash ^ byte) * 0x100000001b3; };
    write(add, system);
    return hash;
}

} // namespace particles
