#include "collision/triangle_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace collision {

std::optional<NearestTriangle> nearest_triangle(const glm::dvec3& p, std::span<const Triangle> triangles)
{
    std::optional<NearestTriangle> nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const glm::dvec3 point = closest_point_on_triangle(p, triangles[i]);
        const double square = glm::dot(p - point, p - point);
        if (square < smallest) {
            smallest = square;
            nearest = {i, point, std::sqrt(square)};
        }
    }
    return nearest;
}

double winding_number(const glm::dvec3& p, std::span<const Triangle> triangles)
{
    double half_angles = 0.0;
    for (const Triangle& triangle : triangles) {
        const glm::dvec3 a = glm::dvec3(triangle.a) - p;
        const glm::dvec3 b = glm::dvec3(triangle.b) - p;
        const glm::dvec3 c = glm::dvec3(triangle.c) - p;
        const double length_a = glm::length(a);
        const double length_b = glm::length(b);
        const double length_c = glm::length(c);
        const double sine = glm::dot(a, glm::cross(b, c));
        const double cosine = length_a * length_b * length_c + glm::dot(a, b) * length_c +
                              glm::dot(b, c) * length_a + glm::dot(c, a) * length_b;
        half_angles += std::atan2(sine, cosine);
    }
    return half_angles / (2.0 * std::numbers::pi);
}

bool is_point_inside_mesh(const glm::dvec3& p, std::span<const Triangle> triangles)
{
    return std::abs(winding_number(p, triangles)) >= 0.5;
}

} // namespace collision
