#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace base {

/// Returns metres as whole millimetres, rounded. Precondition: finite. Clamped at a million kilometres.
std::int64_t to_millimetres(double metres);

/// Returns metres as a short decimal, to the millimetre, such as "1.25".
std::string in_metres(double metres);

/// Returns "(1, 2.5, -0.25)".
std::string in_metres(const glm::dvec3& point);

/// Returns a factor with four digits that count, such as "0.04369", and at most nine decimals.
/// Precondition: positive, at most a million.
std::string factor_text(double factor);

} // namespace base
