#include "collision/triangle.h"

#include "collision/closest_point.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace collision {

namespace {

double squared_distance(const glm::dvec3& p, const glm::dvec3& q)
{
    return glm::dot(p - q, p - q);
}

glm::dvec3 closest_point_on_edges(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                  const glm::dvec3& c)
{
    glm::dvec3 best = closest_point_on_segment(p, a, b).point;
    for (const glm::dvec3& other :
         {closest_point_on_segment(p, b, c).point, closest_point_on_segment(p, c, a).point}) {
        if (squared_distance(p, other) < squared_distance(p, best)) {
            best = other;
        }
    }
    return best;
}

} // namespace

glm::dvec3 closest_point_on_triangle(const glm::dvec3& p, const Triangle& triangle)
{
    const glm::dvec3 a(triangle.a);
    const glm::dvec3 b(triangle.b);
    const glm::dvec3 c(triangle.c);
    // Barycentric coordinates of p's projection, from the signed areas that it makes with the edges.
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double square = glm::dot(normal, normal);
    const double of_b = glm::dot(normal, glm::cross(p - a, c - a));
    const double of_c = glm::dot(normal, glm::cross(b - a, p - a));
    if (of_b > 0.0 && of_c > 0.0 && of_b + of_c < square) {
        return a + (of_b / square) * (b - a) + (of_c / square) * (c - a);
    }
    // Beside the face, or it has no area.
    return closest_point_on_edges(p, a, b, c);
}

std::optional<SegmentHit> intersect_segment_triangle(const glm::dvec3& a, const glm::dvec3& b,
                                                     const Triangle& triangle)
{
    const glm::dvec3 direction = b - a;
    // Seen along the segment's longest axis, sheared so that the segment becomes the origin, each corner has
    // one place in the plane, whichever triangle it is looked at for. So neighbours agree about their edge.
    const glm::dvec3 size = glm::abs(direction);
    const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int x = (z + 1) % 3;
    const int y = (z + 2) % 3;
    if (!(size[z] > 0.0)) {
        return std::nullopt;
    }
    const double shear_x = direction[x] / direction[z];
    const double shear_y = direction[y] / direction[z];
    const auto seen_along = [&](const glm::vec3& corner) {
        const glm::dvec3 from_a = glm::dvec3(corner) - a;
        return glm::dvec3(from_a[x] - shear_x * from_a[z], from_a[y] - shear_y * from_a[z], from_a[z]);
    };
    const std::array corners = {seen_along(triangle.a), seen_along(triangle.b), seen_along(triangle.c)};
    // On which side of each edge the origin is. Rounding can make such a difference 0, but never turn its
    // sign, since multiplying is monotone; and 0 counts as inside.
    const auto side = [](const glm::dvec3& p, const glm::dvec3& q) { return p.x * q.y - p.y * q.x; };
    const double u = side(corners[2], corners[1]);
    const double v = side(corners[0], corners[2]);
    const double w = side(corners[1], corners[0]);
    const bool is_outside = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
    if (is_outside) {
        return std::nullopt;
    }
    const double along = (u * corners[0].z + v * corners[1].z + w * corners[2].z) / (u + v + w);
    const double parameter = along / direction[z];
    // Not-a-number where the triangle is seen edge-on, all three sides being 0.
    if (!(parameter >= 0.0 && parameter <= 1.0)) {
        return std::nullopt;
    }
    return SegmentHit{a + parameter * direction, parameter};
}

} // namespace collision
