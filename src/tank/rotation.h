#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace tank {

/// Returns the matrix that glRotate(angle, axis) multiplies by, in double. Radians, right-handed.
/// An axis along X, Y or Z gives exact zeros and ones beside the sines and cosines; others are normalised
/// first. A zero axis gives the identity. OpenGL 1.5, 2.11.2.
glm::dmat4 rotation(const glm::dvec3& axis, double radians);

} // namespace tank
