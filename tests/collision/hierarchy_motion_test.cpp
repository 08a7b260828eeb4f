#include "collision/smallest_sphere.h"
#include "collision/sphere_hierarchy.h"
#include "tests/collision/random_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

namespace collision {
namespace {

TEST(HierarchyMotionTest, QuarterTurnsAndStepsOfAGridChangeNothingAtAll)
{
    // Everything lies on a grid of 1/64 m, so that no number is rounded before the squares.
    Random random(48);
    const auto on_grid = [&](double half) { return glm::round(random.in_box(half) * 64.0) / 64.0; };
    const glm::dmat4 quarter_turn({0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1});
    for (int i = 0; i < 1000; ++i) {
        std::vector<BoundingSphere> local;
        Matrices matrices;
        Matrices moved_matrices;
        glm::dmat4 motion = i % 2 == 0 ? quarter_turn : quarter_turn * quarter_turn;
        motion[3] = glm::dvec4(on_grid(i % 3 == 0 ? 5e4 : 10), 1);
        for (std::size_t part = 0; part < PARTS; ++part) {
            local.push_back({on_grid(2), std::abs(on_grid(1).x)});
            glm::dmat4 matrix = i % 5 == 0 ? quarter_turn : glm::dmat4(1);
            matrix[3] = glm::dvec4(on_grid(4), 1);
            matrices.emplace_back(matrix);
            moved_matrices.emplace_back(motion * matrix);
        }
        SphereHierarchy hierarchy(local);
        SphereHierarchy moved(local);
        hierarchy.refit(matrices);
        moved.refit(moved_matrices);
        for (int j = 0; j < 10; ++j) {
            const glm::dvec3 a = on_grid(6);
            const glm::dvec4 far_a = motion * glm::dvec4(a, 1);
            ASSERT_EQ(moved.hit_test(Query::point(far_a)).parts, hierarchy.hit_test(Query::point(a)).parts)
                << i;
        }
        for (std::size_t part = 0; part < PARTS; ++part) {
            ASSERT_EQ(moved.parts()[part].radius, hierarchy.parts()[part].radius);
            ASSERT_EQ(moved.parts()[part].centre,
                      glm::dvec3(motion * glm::dvec4(hierarchy.parts()[part].centre, 1)));
        }
    }
}

TEST(HierarchyMotionTest, ARigidMotionChangesNothingButRounding)
{
    // The matrices are floats: turned once more, they round by 1e-7 of the parts' 10 m.
    constexpr double ROUNDING = 1e-5;
    Random random(49);
    for (int i = 0; i < 400; ++i) {
        std::vector<BoundingSphere> local;
        for (std::size_t part = 0; part < PARTS; ++part) {
            local.push_back({random.in_box(1), random.any_size(0.01, 2)});
        }
        const Matrices matrices = random_pose(random, 5, false);
        const glm::dmat4 motion = random.rigid_motion(20);
        Matrices moved_matrices;
        for (const glm::mat4& matrix : matrices) {
            moved_matrices.emplace_back(motion * glm::dmat4(matrix));
        }
        SphereHierarchy hierarchy(local);
        SphereHierarchy moved(local);
        hierarchy.refit(matrices);
        moved.refit(moved_matrices);
        ASSERT_NEAR(hierarchy.root().radius, moved.root().radius, ROUNDING);
        for (int j = 0; j < 20; ++j) {
            const Query query = random_query(random, hierarchy.parts()[random.index(PARTS)]);
            Query moved_query = query;
            moved_query.origin = glm::dvec3(motion * glm::dvec4(query.origin, 1));
            moved_query.end = glm::dvec3(motion * glm::dvec4(query.end, 1));
            moved_query.direction = glm::dvec3(motion * glm::dvec4(query.direction, 0));
            const Explanation before = hierarchy.explain(query);
            const Explanation after = moved.explain(moved_query);
            if (std::abs(before.root.depth) > ROUNDING) {
                ASSERT_EQ(before.root.is_inside, after.root.is_inside) << i;
            }
            for (std::size_t part = 0; part < std::min(before.parts.size(), after.parts.size()); ++part) {
                const SphereTest& test = before.parts[part];
                ASSERT_NEAR(test.depth, after.parts[part].depth, ROUNDING) << i;
                if (std::abs(test.depth) > ROUNDING) {
                    ASSERT_EQ(test.is_inside, after.parts[part].is_inside) << i;
                }
            }
        }
    }
}

TEST(HierarchyMotionTest, ACentimetreAMillionMetresAwayIsHitAndMissedByATenthOfAMillimetre)
{
    Random random(50);
    for (int i = 0; i < 2000; ++i) {
        const std::vector<BoundingSphere> local{{random.in_box(0.5), 0.01}, {{3, 0, 0}, 0.01}};
        SphereHierarchy hierarchy(local);
        glm::mat4 matrix(random.rotation());
        matrix[3] = glm::vec4(glm::vec3(random.in_box(1e6)), 1);
        hierarchy.refit(Matrices{matrix, matrix});
        const glm::dvec3 centre(glm::dmat4(matrix) * glm::dvec4(local[0].centre, 1));
        const glm::dvec3 away = random.direction();
        const glm::dvec3 along = glm::cross(away, random.direction()) * 1e6;
        for (const double out : {0.0099, 0.0101}) {
            const glm::dvec3 point = centre + out * away;
            const bool expected = out < 0.01;
            ASSERT_EQ(hierarchy.hit_test(Query::point(point)).parts.contains(0), expected) << i;
            ASSERT_EQ(hierarchy.hit_test(Query::segment(point - along, point + along)).parts.contains(0),
                      expected);
            ASSERT_EQ(hierarchy.hit_test(Query::ray(point - along, along)).parts.contains(0), expected);
            ASSERT_EQ(hierarchy.hit_test(Query::line(point + along, along)).parts.contains(0), expected);
            ASSERT_EQ(hierarchy.hit_test(Query::point(centre + (out + 0.5) * away, 0.5)).parts.contains(0),
                      expected);
        }
    }
}

TEST(HierarchyMotionTest, AProjectileTunnelsThroughNothingAtAnySpeed)
{
    // The way flown in each step, end to end, meets what the whole way meets.
    Random random(51);
    for (int i = 0; i < 300; ++i) {
        const SphereHierarchy hierarchy = random_hierarchy(random, 3, 0.05);
        const glm::dvec3 target = hierarchy.parts()[random.index(PARTS)].centre;
        const glm::dvec3 from = target + 20.0 * random.direction();
        const glm::dvec3 velocity = 2.0 * (target - from); // a second flies twice as far
        const PartSet whole = hierarchy.hit_test(Query::segment(from, from + velocity, 0.01)).parts;
        ASSERT_FALSE(whole.is_empty());
        for (const int steps : {1, 3, 7, 60, 200}) {
            PartSet met;
            for (int step = 0; step < steps; ++step) {
                const glm::dvec3 a = from + velocity * (static_cast<double>(step) / steps);
                const glm::dvec3 b = from + velocity * (static_cast<double>(step + 1) / steps);
                met = PartSet(met.bits() | hierarchy.hit_test(Query::segment(a, b, 0.01)).parts.bits());
            }
            ASSERT_EQ(met, whole) << steps;
        }
    }
}

/// FNV-1a over the bytes of numbers.
class Hash
{
public:
    void add(double number)
    {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        for (int byte = 0; byte < 8; ++byte) {
            value_ = (value_ ^ (bits >> 8 * byte & 255u)) * 1099511628211u;
        }
    }
    void add(const BoundingSphere& sphere)
    {
        add(sphere.centre.x);
        add(sphere.centre.y);
        add(sphere.centre.z);
        add(sphere.radius);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

TEST(HierarchyMotionTest, EveryNumberIsTheSameOnEveryMachine)
{
    // As WebAssembly, too. When something is computed in another way on purpose, the hash changes.
    Random random(52);
    Hash hash;
    for (int i = 0; i < 200; ++i) {
        const std::vector<glm::vec3> points = random.cloud(50, 5, 3);
        hash.add(average_sphere(points));
        hash.add(smallest_sphere(points));
        SphereHierarchy hierarchy = random_hierarchy(random, 100);
        hierarchy.refit(random_pose(random, 100));
        hash.add(hierarchy.root());
        for (int j = 0; j < 20; ++j) {
            const Query query = random_query(random, hierarchy.parts()[random.index(PARTS)]);
            const Explanation told = hierarchy.explain(query);
            hash.add(told.root.depth);
            for (const SphereTest& test : told.parts) {
                hash.add(test.sphere);
                hash.add(test.parameter);
                hash.add(test.distance);
                hash.add(test.depth);
            }
        }
    }
    EXPECT_EQ(hash.value(), 6455320301373345600u);
}

} // namespace
} // namespace collision
