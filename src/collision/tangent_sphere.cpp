#include "collision/tangent_sphere.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace collision {

namespace {

/// Solves q_j . y = b_j for y in the space that the one to three q span, for two right sides at once.
/// False where the q are dependent.
bool solve(std::span<const glm::dvec3> q, const std::array<double, 3>& b, const std::array<double, 3>& c,
           glm::dvec3& y, glm::dvec3& z)
{
    // By the dual basis: the vectors d_j with d_j . q_k = 1 for j = k and else 0.
    std::array<glm::dvec3, 3> dual{};
    if (q.size() == 1) {
        dual[0] = q[0] / glm::dot(q[0], q[0]);
    } else if (q.size() == 2) {
        const glm::dvec3 normal = glm::cross(q[0], q[1]);
        const double square = glm::dot(normal, normal);
        dual[0] = glm::cross(q[1], normal) / square;
        dual[1] = glm::cross(normal, q[0]) / square;
    } else {
        const double volume = glm::dot(q[0], glm::cross(q[1], q[2]));
        dual[0] = glm::cross(q[1], q[2]) / volume;
        dual[1] = glm::cross(q[2], q[0]) / volume;
        dual[2] = glm::cross(q[0], q[1]) / volume;
    }
    y = z = glm::dvec3(0.0);
    for (std::size_t j = 0; j < q.size(); ++j) {
        y += b[j] * dual[j];
        z += c[j] * dual[j];
    }
    return std::isfinite(glm::dot(y, y)) && std::isfinite(glm::dot(z, z));
}

} // namespace

Centres tangent_sphere_centres(std::span<const BoundingSphere> spheres)
{
    const glm::dvec3 first = spheres[0].centre;
    if (spheres.size() == 1) {
        return {{first}, 1};
    }
    // With y from the first centre to the one sought, s = the radius sought - the first radius, q_j and d_j
    // the other centres and radii from the first: |y| = s and |y - q_j| = s - d_j. The difference of their
    // squares is linear, 2 q_j . y = |q_j|^2 - d_j^2 + 2 s d_j, so y = u + s v; then |u + s v|^2 = s^2.
    std::array<glm::dvec3, 3> q{};
    std::array<double, 3> constant{};
    std::array<double, 3> linear{};
    const std::size_t others = spheres.size() - 1;
    double smallest = 0.0; // the sphere sought is at least as large as each
    for (std::size_t j = 0; j < others; ++j) {
        q[j] = spheres[j + 1].centre - first;
        const double d = spheres[j + 1].radius - spheres[0].radius;
        constant[j] = 0.5 * (glm::dot(q[j], q[j]) - d * d);
        linear[j] = d;
        smallest = std::fmax(smallest, d);
    }
    glm::dvec3 u;
    glm::dvec3 v;
    Centres result;
    if (!solve(std::span(q).first(others), constant, linear, u, v)) {
        return result;
    }
    const auto add = [&](double s) {
        if (s >= smallest && std::isfinite(s)) {
            result.centres[static_cast<std::size_t>(result.count++)] = first + u + s * v;
        }
    };
    // a s^2 - 2 b s - c = 0
    const double a = 1.0 - glm::dot(v, v);
    const double b = glm::dot(u, v);
    const double c = glm::dot(u, u);
    const double discriminant = b * b + a * c;
    if (!(discriminant >= 0.0)) {
        return result;
    }
    // The root without cancellation first, the other from the product of both, -c / a.
    const double sum = b >= 0.0 ? b + std::sqrt(discriminant) : b - std::sqrt(discriminant);
    add(sum / a);
    add(-c / sum);
    return result;
}

} // namespace collision
