#pragma once

#include "collision/bounding_sphere.h"

#include <glm/mat4x4.hpp>

namespace collision {

/// Returns a sphere that contains whatever `sphere` contains, after `matrix`, in exact arithmetic.
/// The centre is transformed and the radius multiplied by the matrix's largest stretch, so it is the tightest
/// such sphere for a rigid motion and a uniform scale, and contains the ellipsoid under a non-uniform scale
/// or a shear. Where nothing is rounded (quarter turns, translations on the grid of doubles, scaling by a
/// power of two) the radius is exact; elsewhere it is up to 1e-6 of itself larger. The empty sphere stays
/// empty. Precondition: the matrix is affine and finite.
BoundingSphere transformed(const BoundingSphere& sphere, const glm::mat4& matrix);

} // namespace collision
