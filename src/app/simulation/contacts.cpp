#include "app/simulation/contacts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace app {

void Contacts::place(const glm::dvec3& position, double radius, const collision::SphereHierarchy& spheres)
{
    last_ = position;
    inside_ = spheres.hit_test(collision::Query::point(position, radius)).parts;
}

void Contacts::launch(const glm::dvec3& position)
{
    last_ = position;
    inside_ = {};
}

/// Ericson, Real-Time Collision Detection (2005), 5.3.2, for a segment that touches the sphere.
glm::dvec3 Contacts::first_place_inside(const collision::BoundingSphere& sphere, const glm::dvec3& from,
                                        const glm::dvec3& to, double radius)
{
    const glm::dvec3 way = to - from;
    const glm::dvec3 from_centre = from - sphere.centre;
    const double reach = sphere.radius + radius;
    const double a = glm::dot(way, way);
    const double half_b = glm::dot(from_centre, way);
    const double c = glm::dot(from_centre, from_centre) - reach * reach;
    if (c <= 0.0 || a == 0.0) {
        return from;
    }
    const double root = std::sqrt(std::max(half_b * half_b - a * c, 0.0)); // below 0 only by rounding
    return from + std::clamp((-half_b - root) / a, 0.0, 1.0) * way;
}

} // namespace app
