#pragma once

#include "collision/sphere_hierarchy.h"
#include "tests/collision/random_geometry.h"

#include <vector>

// Random hierarchies in random poses, and queries that come near them.
namespace collision {

constexpr std::size_t PARTS = 18;

using Matrices = std::vector<glm::mat4>;

/// A pose: each part turned and placed somehow, all within `far` of the origin; some of them stretched.
inline Matrices random_pose(Random& random, double far, bool may_stretch = true)
{
    Matrices matrices;
    const glm::dvec3 place = random.in_box(far);
    for (std::size_t i = 0; i < PARTS; ++i) {
        glm::dmat4 matrix = random.rigid_motion(4);
        if (may_stretch && random.index(6) == 0) {
            const glm::dvec3 scale = random.scales(0.2, 3);
            matrix[0] *= scale.x;
            matrix[1] *= scale.y;
            matrix[2] *= scale.z;
        }
        matrix[3] += glm::dvec4(place, 0);
        matrices.emplace_back(matrix);
    }
    return matrices;
}

inline SphereHierarchy random_hierarchy(Random& random, double far = 10, double largest_radius = 2)
{
    std::vector<BoundingSphere> local;
    for (std::size_t i = 0; i < PARTS; ++i) {
        local.push_back({random.in_box(1), random.any_size(0.01, largest_radius)});
    }
    SphereHierarchy hierarchy(local);
    hierarchy.refit(random_pose(random, far, false));
    return hierarchy;
}

/// A query near the sphere: most of them near its surface, where it matters.
inline Query random_query(Random& random, const BoundingSphere& sphere)
{
    const double out = random.index(3) == 0 ? random.uniform(0, 3) : random.uniform(0.95, 1.05);
    const glm::dvec3 away = random.direction();
    const glm::dvec3 point = sphere.centre + out * sphere.radius * away;
    glm::dvec3 along = glm::cross(away, random.direction());
    along *= random.any_size(1e-3, 1e3);
    const double radius = random.index(2) == 0 ? 0.0 : random.uniform(0, 0.2) * sphere.radius;
    const double before = random.uniform(-2, 2);
    switch (random.index(4)) {
    case 0:
        return Query::point(point, radius);
    case 1:
        return Query::segment(point + before * along, point + random.uniform(-2, 2) * along, radius);
    case 2:
        return Query::ray(point + before * along, along, radius);
    default:
        return Query::line(point + before * along, along, radius);
    }
}

} // namespace collision
