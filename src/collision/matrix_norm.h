#pragma once

#include <glm/mat3x3.hpp>

namespace collision {

/// Returns how many times longer the matrix can make a vector, rounded up: its largest singular value.
/// Exactly 1 for the identity and quarter turns; at most 1e-6 of itself too large for anything else.
/// Precondition: finite.
double largest_stretch(const glm::mat3& matrix);

} // namespace collision
