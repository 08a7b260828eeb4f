#include "collision/closest_point.h"
#include "collision/smallest_sphere.h"
#include "collision/sphere_hierarchy.h"
#include "tests/collision/random_hierarchy.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace collision {
namespace {

using Meshes = std::vector<std::vector<glm::vec3>>;

Meshes random_meshes(Random& random)
{
    Meshes meshes;
    for (std::size_t i = 0; i < PARTS; ++i) {
        meshes.push_back(random.cloud(30, 2, random.any_size(0.01, 3)));
        if (random.index(20) == 0) {
            meshes.back().clear();
        }
    }
    return meshes;
}

std::vector<BoundingSphere> spheres_of(const Meshes& meshes, bool smallest)
{
    std::vector<BoundingSphere> spheres;
    for (const std::vector<glm::vec3>& mesh : meshes) {
        spheres.push_back(smallest ? smallest_sphere(mesh) : average_sphere(mesh));
    }
    return spheres;
}

/// The same question without the hierarchy.
PartSet brute_force(std::span<const BoundingSphere> spheres, const Query& query)
{
    PartSet hits;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        ClosestPoint closest{query.origin, 0};
        if (query.shape == Shape::segment) {
            closest = closest_point_on_segment(spheres[i].centre, query.origin, query.end);
        } else if (query.shape == Shape::ray) {
            closest = closest_point_on_ray(spheres[i].centre, query.origin, query.direction);
        } else if (query.shape == Shape::line) {
            closest = closest_point_on_line(spheres[i].centre, query.origin, query.direction);
        }
        BoundingSphere grown = spheres[i];
        grown.radius += grown.is_empty() ? 0 : query.radius;
        if (grown.contains(closest.point)) {
            hits.insert(i);
        }
    }
    return hits;
}

bool has_all(PartSet larger, PartSet smaller)
{
    return (smaller.bits() & ~larger.bits()) == 0;
}

TEST(HierarchyPropertyTest, EveryVertexIsInItsPartsSphereAndEverySphereInTheRoot)
{
    Random random(40);
    for (int i = 0; i < 150; ++i) {
        const Meshes meshes = random_meshes(random);
        SphereHierarchy hierarchy(spheres_of(meshes, i % 2 == 0));
        for (int pose = 0; pose < 15; ++pose) {
            const double far = pose % 3 == 0 ? 1e6 : 50;
            const Matrices matrices = random_pose(random, far);
            hierarchy.refit(matrices);
            const BoundingSphere& root = hierarchy.root();
            for (std::size_t part = 0; part < PARTS; ++part) {
                const BoundingSphere& sphere = hierarchy.parts()[part];
                for (const glm::vec3& vertex : meshes[part]) {
                    ASSERT_LE(out_of_sphere(sphere.centre, sphere.radius, matrices[part], vertex), 0.0L) << i;
                }
                if (meshes[part].empty()) {
                    ASSERT_TRUE(sphere.is_empty());
                } else {
                    ASSERT_LE(out_of_sphere(root.centre, root.radius, sphere.centre) +
                                  static_cast<Exact>(sphere.radius),
                              0.0L)
                        << i;
                }
            }
        }
    }
}

TEST(HierarchyPropertyTest, SpheresAreNoLargerThanTheMeshInItsPoseNeeds)
{
    // A sphere that stayed behind, or was made safe by making it huge, would be found here.
    Random random(41);
    for (int i = 0; i < 300; ++i) {
        const Meshes meshes = random_meshes(random);
        SphereHierarchy hierarchy(spheres_of(meshes, true));
        const Matrices matrices = random_pose(random, 50, false);
        hierarchy.refit(matrices);
        for (std::size_t part = 0; part < PARTS; ++part) {
            const BoundingSphere& sphere = hierarchy.parts()[part];
            double furthest = 0;
            for (const glm::vec3& vertex : meshes[part]) {
                const glm::dvec3 placed(glm::dmat4(matrices[part]) * glm::dvec4(vertex, 1));
                furthest = std::max(furthest, glm::distance(placed, sphere.centre));
            }
            ASSERT_NEAR(furthest, std::max(sphere.radius, 0.0), 1e-5) << i;
        }
        const BoundingSphere fresh = smallest_enclosing(hierarchy.parts());
        ASSERT_NEAR(hierarchy.root().radius, fresh.radius, 1e-8) << i;
    }
}

TEST(HierarchyPropertyTest, RefittingInStepsIsRefittingAtOnce)
{
    Random random(42);
    for (int i = 0; i < 100; ++i) {
        const std::vector<BoundingSphere> local = spheres_of(random_meshes(random), true);
        SphereHierarchy in_steps(local);
        in_steps.carry_whole({{0, 1, 0}, 4}, 3);
        Matrices matrices(PARTS, glm::mat4(1));
        std::uint64_t expected_parts = 0;
        for (int step = 0; step < 20; ++step) {
            const Matrices pose = random_pose(random, 10);
            for (std::size_t part = 0; part < PARTS; ++part) {
                if (random.index(4) == 0) {
                    matrices[part] = pose[part];
                    ++expected_parts;
                }
            }
            in_steps.refit(matrices);
            SphereHierarchy at_once(local);
            at_once.carry_whole({{0, 1, 0}, 4}, 3);
            at_once.refit(matrices);
            ASSERT_EQ(in_steps.root(), at_once.root());
            ASSERT_EQ(in_steps.whole(), at_once.whole());
            for (std::size_t part = 0; part < PARTS; ++part) {
                ASSERT_EQ(in_steps.parts()[part], at_once.parts()[part]);
            }
        }
        ASSERT_EQ(in_steps.refit_counts().parts, expected_parts);
        ASSERT_LE(in_steps.refit_counts().roots, 20u);
    }
}

TEST(HierarchyPropertyTest, TheHierarchyHitsWhatBruteForceHits)
{
    Random random(43);
    int hits = 0;
    int misses = 0;
    for (int i = 0; i < 400; ++i) {
        const SphereHierarchy hierarchy =
            random_hierarchy(random, i % 4 == 0 ? 1e6 : 10, i % 3 == 0 ? 0.1 : 2);
        for (int j = 0; j < 100; ++j) {
            const BoundingSphere& target =
                j % 5 == 0 ? hierarchy.root() : hierarchy.parts()[random.index(PARTS)];
            const Query query = random_query(random, target);
            const HitResult result = hierarchy.hit_test(query);
            ASSERT_EQ(result.refusal, Refusal::none);
            ASSERT_EQ(result.parts, brute_force(hierarchy.parts(), query)) << i;
            (result.parts.is_empty() ? misses : hits) += 1;
        }
    }
    EXPECT_GT(hits, 5000);
    EXPECT_GT(misses, 5000);
}

TEST(HierarchyPropertyTest, NothingIsLostWhereTheRootTouchesAPart)
{
    // A single part, or a part that holds the root: whatever grazes the one grazes the other.
    Random random(44);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 place = random.in_box(i % 2 == 0 ? 10 : 1e6);
        const std::vector<BoundingSphere> local{{place, random.any_size(0.01, 5)}};
        const SphereHierarchy hierarchy(local);
        const glm::dvec3 away = random.direction();
        const glm::dvec3 point = place + local[0].radius * away;
        const glm::dvec3 along = glm::normalize(glm::cross(away, random.direction()));
        const double far = i % 3 == 0 ? 1e6 : 10;
        const Query tangent = Query::segment(point - far * along, point + far * along);
        const PartSet expected = brute_force(local, tangent);
        ASSERT_EQ(hierarchy.hit_test(tangent).parts, expected) << i;
        ASSERT_EQ(hierarchy.hit_test(Query::point(point)).parts, brute_force(local, Query::point(point)))
            << i;
        hits += expected.count();
    }
    EXPECT_GT(hits, 4000); // rounding decides, so that there are many of both
    EXPECT_LT(hits, 16000);
}

TEST(HierarchyPropertyTest, AnExplanationAgreesWithTheShortAnswer)
{
    Random random(45);
    for (int i = 0; i < 300; ++i) {
        const SphereHierarchy hierarchy = random_hierarchy(random);
        for (int j = 0; j < 30; ++j) {
            const Query query = random_query(random, hierarchy.parts()[random.index(PARTS)]);
            const HitResult result = hierarchy.hit_test(query);
            const Explanation told = hierarchy.explain(query);
            ASSERT_EQ(told.hits, result.parts);
            ASSERT_EQ(told.root.is_inside, result.is_root_entered);
            ASSERT_EQ(told.parts.size(), result.is_root_entered ? PARTS : 0u);
            for (std::size_t part = 0; part < told.parts.size(); ++part) {
                const SphereTest& test = told.parts[part];
                ASSERT_EQ(test.sphere, hierarchy.parts()[part]);
                ASSERT_EQ(test.is_inside, result.parts.contains(part));
                ASSERT_EQ(test.is_inside, test.depth >= 0);
                ASSERT_NEAR(test.depth, test.sphere.radius + query.radius - test.distance, 1e-12);
                ASSERT_NEAR(test.distance, glm::distance(test.closest_point, test.sphere.centre), 1e-12);
                if (query.shape != Shape::point) {
                    const glm::dvec3 on_line = query.origin + test.parameter * query.direction;
                    const double size = glm::length(query.origin) + glm::length(query.direction);
                    ASSERT_LE(glm::distance(on_line, test.closest_point), 1e-14 * size);
                }
            }
        }
    }
}

TEST(HierarchyPropertyTest, ASegmentIsTheLimitOfManyPoints)
{
    Random random(46);
    for (int i = 0; i < 200; ++i) {
        const SphereHierarchy hierarchy = random_hierarchy(random, 3);
        const glm::dvec3 a = hierarchy.root().centre + random.in_box(6);
        const glm::dvec3 b = i % 20 == 0 ? a : hierarchy.root().centre + random.in_box(6);
        const PartSet by_segment = hierarchy.hit_test(Query::segment(a, b)).parts;
        const Explanation told = hierarchy.explain(Query::segment(a, b));
        PartSet by_points;
        for (const int samples : {1, 2, 4, 16, 64, 256}) {
            PartSet finer;
            for (int j = 0; j <= samples; ++j) {
                const double t = static_cast<double>(j) / samples;
                const glm::dvec3 point = j == samples ? b : a + t * (b - a);
                finer = PartSet(finer.bits() | hierarchy.hit_test(Query::point(point)).parts.bits());
            }
            ASSERT_TRUE(has_all(finer, by_points)) << i;  // more points hit more
            ASSERT_TRUE(has_all(by_segment, finer)) << i; // and nothing that the segment does not
            by_points = finer;
            // What the segment enters by more than half a step, a point has met.
            const double half_step = 0.5 * glm::distance(a, b) / samples;
            for (std::size_t part = 0; part < told.parts.size(); ++part) {
                if (told.parts[part].depth > half_step) {
                    ASSERT_TRUE(finer.contains(part)) << i;
                }
            }
        }
    }
}

TEST(HierarchyPropertyTest, ALongerOneHitsNoLess)
{
    Random random(47);
    for (int i = 0; i < 3000; ++i) {
        const SphereHierarchy hierarchy = random_hierarchy(random, 5);
        const Query query = random_query(random, hierarchy.parts()[random.index(PARTS)]);
        const glm::dvec3 a = query.origin;
        const glm::dvec3 d = query.direction;
        const PartSet point = hierarchy.hit_test(Query::point(a)).parts;
        const PartSet segment = hierarchy.hit_test(Query::segment(a, a + d)).parts;
        const PartSet ray = hierarchy.hit_test(Query::ray(a, d)).parts;
        const PartSet line = hierarchy.hit_test(Query::line(a, d)).parts;
        const PartSet thick_line = hierarchy.hit_test(Query::line(a, d, 0.1)).parts;
        ASSERT_TRUE(has_all(segment, point)) << i;
        ASSERT_TRUE(has_all(ray, segment)) << i;
        ASSERT_TRUE(has_all(line, ray)) << i;
        ASSERT_TRUE(has_all(thick_line, line)) << i;
    }
}

} // namespace
} // namespace collision
