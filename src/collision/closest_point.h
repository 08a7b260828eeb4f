#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace collision {

/// Holds a point of a line and its parameter: point = start + parameter * direction.
struct ClosestPoint
{
    glm::dvec3 point;
    double parameter;
};

/// Returns the point of the infinite line through `origin` closest to p, and its parameter in units of
/// `direction`, which may have any length. A direction whose square vanishes (shorter than 1e-154 m) is none:
/// the line is the point `origin`, the parameter 0.
/// Ericson, Real-Time Collision Detection (2005), 5.1.2, without the clamping.
inline ClosestPoint closest_point_on_line(const glm::dvec3& p, const glm::dvec3& origin,
                                          const glm::dvec3& direction)
{
    const double square = glm::dot(direction, direction);
    if (!(square >= std::numeric_limits<double>::min())) {
        return {origin, 0.0};
    }
    const double parameter = glm::dot(p - origin, direction) / square;
    return {origin + parameter * direction, parameter};
}

/// Returns the point of the ray closest to p, and its parameter, at least 0, in units of `direction`.
/// For what lies behind the ray that is its origin. Without a direction the ray is the point `origin`.
/// Ericson, Real-Time Collision Detection (2005), 5.1.2, clamped at one end.
inline ClosestPoint closest_point_on_ray(const glm::dvec3& p, const glm::dvec3& origin,
                                         const glm::dvec3& direction)
{
    const ClosestPoint on_line = closest_point_on_line(p, origin, direction);
    return on_line.parameter > 0.0 ? on_line : ClosestPoint{origin, 0.0};
}

/// Returns the point of segment [a, b] closest to p, and its parameter in [0, 1].
/// The ends are returned as they are, to the bit. a == b is a point; the parameter is then 0. Metres.
/// Ericson, Real-Time Collision Detection (2005), 5.1.2.
inline ClosestPoint closest_point_on_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 direction = b - a;
    const double along = glm::dot(p - a, direction);
    if (!(along > 0.0)) {
        return {a, 0.0};
    }
    const double square = glm::dot(direction, direction);
    if (along >= square) {
        return {b, 1.0};
    }
    return {a + along / square * direction, along / square};
}

} // namespace collision
