#include "collision/sphere_hierarchy.h"

#include "collision/closest_point.h"
#include "collision/smallest_sphere.h"
#include "collision/transformed_sphere.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace collision {

namespace {

/// Calls visit with a function that returns the query's closest point to a centre. Deciding its shape here,
/// once, leaves the loops over the parts without branches.
template <class Visit> auto with_closest_point(const Query& query, Visit visit)
{
    switch (query.shape) {
    case Shape::segment:
        return visit([a = query.origin, b = query.end](const glm::dvec3& centre) {
            return closest_point_on_segment(centre, a, b);
        });
    case Shape::ray:
        return visit([origin = query.origin, direction = query.direction](const glm::dvec3& centre) {
            return closest_point_on_ray(centre, origin, direction);
        });
    case Shape::line:
        return visit([origin = query.origin, direction = query.direction](const glm::dvec3& centre) {
            return closest_point_on_line(centre, origin, direction);
        });
    case Shape::point:
        break;
    }
    return visit([point = query.origin](const glm::dvec3&) { return ClosestPoint{point, 0.0}; });
}

/// The squares of a distance and of how far the sphere and the query reach together; of an empty sphere, -1.
struct Squares
{
    double distance;
    double reach;

    /// The only place that says what inside means.
    bool is_inside() const { return distance <= reach; }
};

Squares squares(const BoundingSphere& sphere, const glm::dvec3& closest_point, double query_radius)
{
    const glm::dvec3 from_centre = closest_point - sphere.centre;
    const double reach = sphere.radius + query_radius;
    return {glm::dot(from_centre, from_centre), sphere.is_empty() ? -1.0 : reach * reach};
}

template <class Closest>
bool is_inside(const BoundingSphere& sphere, const Closest& closest, double query_radius)
{
    return squares(sphere, closest(sphere.centre).point, query_radius).is_inside();
}

template <class Closest>
SphereTest tested(const BoundingSphere& sphere, const Closest& closest, double query_radius)
{
    const ClosestPoint point = closest(sphere.centre);
    const Squares square = squares(sphere, point.point, query_radius);
    SphereTest test{.sphere = sphere,
                    .closest_point = point.point,
                    .parameter = point.parameter,
                    .distance = std::sqrt(square.distance),
                    .depth = sphere.radius + query_radius,
                    .is_inside = square.is_inside()};
    if (sphere.is_empty()) {
        test.depth = sphere.radius - test.distance; // however thick the query is
    } else if (test.depth + test.distance > 0.0) {
        // The difference as that of the squares, whose sign is the answer's.
        test.depth = (square.reach - square.distance) / (test.depth + test.distance);
    }
    return test;
}

} // namespace

SphereHierarchy::SphereHierarchy(std::span<const BoundingSphere> local_spheres)
    : local_(local_spheres.begin(), local_spheres.end()), matrices_(local_.size(), glm::mat4(1.0f)),
      parts_(local_)
{
    assert(local_.size() <= MAX_PARTS);
    fit_root();
    counts_ = {}; // what follows is counted
}

void SphereHierarchy::carry_whole(const BoundingSphere& local_sphere, std::size_t part)
{
    assert(part < matrices_.size());
    whole_local_ = local_sphere;
    whole_part_ = part;
    whole_ = transformed(whole_local_, matrices_[whole_part_]);
}

void SphereHierarchy::refit(std::span<const glm::mat4> part_matrices)
{
    assert(part_matrices.size() == parts_.size());
    bool has_moved = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (part_matrices[i] == matrices_[i]) {
            continue;
        }
        matrices_[i] = part_matrices[i];
        const BoundingSphere moved = transformed(local_[i], matrices_[i]);
        ++counts_.parts;
        has_moved |= moved != parts_[i];
        parts_[i] = moved;
        if (i == whole_part_) {
            whole_ = transformed(whole_local_, matrices_[i]);
        }
    }
    if (has_moved) {
        fit_root();
    }
}

void SphereHierarchy::fit_root()
{
    root_ = smallest_enclosing(parts_);
    if (!root_.is_empty()) {
        root_.radius += ROOT_MARGIN + 1e-12 * root_.radius;
    }
    ++counts_.roots;
}

HitResult SphereHierarchy::hit_test(const Query& query) const
{
    HitResult result;
    result.refusal = refusal_of(query);
    if (result.refusal != Refusal::none) {
        return result;
    }
    with_closest_point(query, [&](const auto& closest) {
        result.is_root_entered = is_inside(root_, closest, query.radius);
        if (!result.is_root_entered) {
            return;
        }
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            bits |= static_cast<std::uint64_t>(is_inside(parts_[i], closest, query.radius)) << i;
        }
        result.parts = PartSet(bits);
    });
    return result;
}

Explanation SphereHierarchy::explain(const Query& query) const
{
    Explanation result;
    result.refusal = refusal_of(query);
    if (result.refusal != Refusal::none) {
        return result;
    }
    with_closest_point(query, [&](const auto& closest) {
        result.root = tested(root_, closest, query.radius);
        if (!result.root.is_inside) {
            return;
        }
        result.parts.reserve(parts_.size());
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            result.parts.push_back(tested(parts_[i], closest, query.radius));
            if (result.parts.back().is_inside) {
                result.hits.insert(i);
            }
        }
    });
    return result;
}

} // namespace collision
