#include "collision/bounding_sphere.h"

#include "collision/rounding.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace collision {

bool BoundingSphere::contains(const glm::dvec3& point) const
{
    const glm::dvec3 from_centre = point - centre;
    return !is_empty() && glm::dot(from_centre, from_centre) <= radius * radius;
}

namespace {

/// Calls visit(point) for every point, in double.
template <class Visit> void for_each_point(std::span<const glm::vec3> points, Visit visit)
{
    for (const glm::vec3& point : points) {
        visit(glm::dvec3(point));
    }
}

template <class Visit> void for_each_point(std::span<const PlacedPoints> parts, Visit visit)
{
    for (const PlacedPoints& part : parts) {
        const glm::dmat4 matrix(part.matrix);
        for_each_point(part.points,
                       [&](const glm::dvec3& point) { visit(glm::dvec3(matrix * glm::dvec4(point, 1.0))); });
    }
}

template <class Points> BoundingSphere average_sphere_of(const Points& points)
{
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for_each_point(points, [&](const glm::dvec3& point) {
        sum += point;
        count += 1.0;
    });
    if (count == 0.0) {
        return {};
    }
    const glm::dvec3 centre = sum / count;
    double radius = 0.0;
    for_each_point(points,
                   [&](const glm::dvec3& point) { radius = std::max(radius, distance_up(centre, point)); });
    return {centre, static_cast<double>(float_up(radius))};
}

} // namespace

BoundingSphere average_sphere(std::span<const glm::vec3> points)
{
    return average_sphere_of(points);
}

BoundingSphere average_sphere(std::span<const PlacedPoints> parts)
{
    return average_sphere_of(parts);
}

} // namespace collision
