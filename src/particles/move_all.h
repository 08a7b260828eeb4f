#pragma once

#include "particles/contact.h"
#include "particles/particle_store.h"

#include <cstddef>
#include <span>

namespace particles {

/// Moves all that are not stuck for some seconds, among walls: those that touch none as fly_among_walls()
/// does, but in float and many at a time; the others by fly_among_walls(). What sticks is stuck from now on,
/// what is recycled is taken out. Returns how many were. seconds: 0 to MAX_LIFE.
std::size_t move_all(ParticleStore& store, const Forces& forces, std::span<const Wall> walls, double seconds);

} // namespace particles
