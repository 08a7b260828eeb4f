#include "collision/smallest_sphere.h"

#include "collision/rounding.h"
#include "collision/tangent_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

// The smallest sphere is held by at most four of the things inside. Such a basis is kept and improved: what
// sticks out furthest is added, the sphere around those at most five is found by trying each way in which one
// to four of them may hold it, and what does not hold it is dropped. The radius grows with every round until
// nothing sticks out.
// After the pivot rule of Gaertner, Fast and Robust Smallest Enclosing Balls (1999); that moving to the
// front, as Welzl does, fails for spheres: Fischer and Gaertner (2003). Trying all ways needs no tolerance:
// whatever the centre, the sphere around all five from there is valid, and the smallest of these is right.

namespace collision {

namespace {

/// A sphere and those, touching it from inside, that hold it in place.
struct Basis
{
    std::array<BoundingSphere, 4> holding;
    std::size_t count = 0;
    BoundingSphere sphere;
};

/// How far out of the centre's sight a sphere reaches.
double reach(const glm::dvec3& centre, const BoundingSphere& sphere)
{
    return glm::length(sphere.centre - centre) + sphere.radius;
}

/// Returns the basis of what holds `old` together with `added`, which sticks out of it.
Basis improved(const Basis& old, const BoundingSphere& added)
{
    Basis best;
    best.sphere.radius = std::numeric_limits<double>::infinity();
    // What sticks out holds the new sphere, in each case; with all four old ones it would be one too many.
    const unsigned subsets = old.count == 4 ? 15u : 1u << old.count;
    for (unsigned subset = 0; subset < subsets; ++subset) {
        Basis trial;
        trial.holding[trial.count++] = added;
        for (std::size_t i = 0; i < old.count; ++i) {
            if (subset >> i & 1u) {
                trial.holding[trial.count++] = old.holding[i];
            }
        }
        const Centres tangent = tangent_sphere_centres(std::span(trial.holding).first(trial.count));
        for (int i = 0; i < tangent.count; ++i) {
            trial.sphere.centre = tangent.centres[static_cast<std::size_t>(i)];
            trial.sphere.radius = reach(trial.sphere.centre, added);
            for (std::size_t j = 0; j < old.count; ++j) {
                trial.sphere.radius =
                    std::max(trial.sphere.radius, reach(trial.sphere.centre, old.holding[j]));
            }
            if (trial.sphere.radius < best.sphere.radius) {
                best = trial;
            }
        }
    }
    return best;
}

/// Returns the centre of the smallest sphere around all, beginning with `first`.
/// furthest(centre) returns what sticks out furthest, seen from a centre.
template <class Furthest> glm::dvec3 smallest_sphere_centre(const BoundingSphere& first, Furthest furthest)
{
    // What the basis holds is never larger than the smallest sphere around all; what reaches furthest from
    // the same centre gives one around all that is never smaller. Between them they leave this much.
    constexpr double ENOUGH = 1.0 + 1e-10;
    constexpr int MAX_ROUNDS = 1000; // ten are usual; a guard against going round in circles by rounding
    Basis basis{.holding = {first}, .count = 1, .sphere = first};
    glm::dvec3 best_centre = first.centre;
    double best_reach = std::numeric_limits<double>::infinity();
    for (int round = 0; round < MAX_ROUNDS; ++round) {
        const BoundingSphere out = furthest(basis.sphere.centre);
        const double out_reach = reach(basis.sphere.centre, out);
        if (out_reach < best_reach) {
            best_reach = out_reach;
            best_centre = basis.sphere.centre;
        }
        if (!(out_reach > basis.sphere.radius * ENOUGH)) {
            break;
        }
        const Basis next = improved(basis, out);
        if (!(next.sphere.radius > basis.sphere.radius)) {
            break;
        }
        basis = next;
    }
    return best_centre;
}

} // namespace

BoundingSphere smallest_sphere(std::span<const glm::vec3> points)
{
    if (points.empty()) {
        return {};
    }
    const auto furthest = [&](const glm::dvec3& centre) {
        double largest = -1.0;
        glm::dvec3 result(points[0]);
        for (const glm::vec3& point : points) {
            const glm::dvec3 from_centre = glm::dvec3(point) - centre;
            const double square = glm::dot(from_centre, from_centre);
            if (square > largest) {
                largest = square;
                result = glm::dvec3(point);
            }
        }
        return BoundingSphere{result, 0.0};
    };
    const glm::dvec3 centre = smallest_sphere_centre({glm::dvec3(points[0]), 0.0}, furthest);
    double radius = 0.0;
    for (const glm::vec3& point : points) {
        radius = std::max(radius, distance_up(centre, glm::dvec3(point)));
    }
    return {centre, static_cast<double>(float_up(radius))};
}

BoundingSphere smallest_enclosing(std::span<const BoundingSphere> spheres)
{
    const auto largest = std::max_element(
        spheres.begin(), spheres.end(),
        [](const BoundingSphere& a, const BoundingSphere& b) { return a.radius < b.radius; });
    if (largest == spheres.end() || largest->is_empty()) {
        return {};
    }
    const auto furthest = [&](const glm::dvec3& centre) {
        BoundingSphere result = *largest;
        double furthest_reach = -1.0;
        for (const BoundingSphere& sphere : spheres) {
            if (!sphere.is_empty() && reach(centre, sphere) > furthest_reach) {
                furthest_reach = reach(centre, sphere);
                result = sphere;
            }
        }
        return result;
    };
    // From the largest: where it contains all others it is the answer, to the bit.
    const glm::dvec3 centre = smallest_sphere_centre(*largest, furthest);
    double radius = 0.0;
    for (const BoundingSphere& sphere : spheres) {
        if (!sphere.is_empty()) {
            radius = std::max(radius, sum_up(distance_up(centre, sphere.centre), sphere.radius));
        }
    }
    return {centre, radius};
}

} // namespace collision
