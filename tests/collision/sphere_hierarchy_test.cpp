#include "collision/sphere_hierarchy.h"

#include "collision/smallest_sphere.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace collision {
namespace {

constexpr double MARGIN = 2.0 * SphereHierarchy::ROOT_MARGIN;

glm::mat4 at(float x, float y, float z)
{
    glm::mat4 matrix(1.0f);
    matrix[3] = glm::vec4(x, y, z, 1.0f);
    return matrix;
}

PartSet parts(std::initializer_list<std::size_t> indices)
{
    PartSet set;
    for (const std::size_t index : indices) {
        set.insert(index);
    }
    return set;
}

/// Two spheres of radius 1 at x = -2 and x = 2: the root is around the origin, of radius 3.
SphereHierarchy pair()
{
    const std::vector<BoundingSphere> local{{{-2, 0, 0}, 1}, {{2, 0, 0}, 1}};
    return SphereHierarchy(local);
}

TEST(SphereHierarchyTest, TheRootIsTheSmallestAroundTheParts)
{
    const SphereHierarchy hierarchy = pair();
    EXPECT_EQ(hierarchy.part_count(), 2u);
    EXPECT_EQ(hierarchy.root().centre, glm::dvec3(0));
    EXPECT_NEAR(hierarchy.root().radius, 3, MARGIN);
    EXPECT_GT(hierarchy.root().radius, 3);
}

TEST(SphereHierarchyTest, FirstTheWholeThenOnlyIfInsideEveryPart)
{
    const SphereHierarchy hierarchy = pair();
    const Query outside = Query::point({0, 4, 0});
    EXPECT_FALSE(hierarchy.hit_test(outside).is_root_entered);
    EXPECT_FALSE(hierarchy.explain(outside).root.is_inside);
    EXPECT_TRUE(hierarchy.explain(outside).parts.empty());

    const Query between = Query::point({0, 1, 0});
    EXPECT_TRUE(hierarchy.hit_test(between).is_root_entered);
    EXPECT_TRUE(hierarchy.hit_test(between).parts.is_empty());
    EXPECT_TRUE(hierarchy.explain(between).root.is_inside);
    ASSERT_EQ(hierarchy.explain(between).parts.size(), 2u);
    EXPECT_FALSE(hierarchy.explain(between).parts[0].is_inside);
    EXPECT_FALSE(hierarchy.explain(between).parts[1].is_inside);
    EXPECT_TRUE(hierarchy.explain(between).hits.is_empty());

    const Query inside = Query::point({2, 0.5, 0});
    EXPECT_EQ(hierarchy.hit_test(inside).parts, parts({1}));
    EXPECT_EQ(hierarchy.explain(inside).hits, parts({1}));
}

TEST(SphereHierarchyTest, AnExplanationSaysWhatWasTestedAndHowItCameOut)
{
    const SphereHierarchy hierarchy = pair();
    const Explanation told = hierarchy.explain(Query::segment({2, 0.5, -4}, {2, 0.5, 4}));
    ASSERT_EQ(told.parts.size(), 2u);
    EXPECT_EQ(told.root.sphere, hierarchy.root());
    EXPECT_EQ(told.root.closest_point, glm::dvec3(2, 0.5, 0));
    EXPECT_EQ(told.root.parameter, 0.5);
    EXPECT_DOUBLE_EQ(told.root.distance, std::sqrt(4.25));
    EXPECT_NEAR(told.root.depth, 3 - std::sqrt(4.25), MARGIN);
    EXPECT_TRUE(told.root.is_inside);

    const SphereTest& missed = told.parts[0];
    EXPECT_EQ(missed.sphere, (BoundingSphere{{-2, 0, 0}, 1}));
    EXPECT_EQ(missed.closest_point, glm::dvec3(2, 0.5, 0));
    EXPECT_DOUBLE_EQ(missed.distance, std::sqrt(16.25));
    EXPECT_DOUBLE_EQ(missed.depth, 1 - std::sqrt(16.25));
    EXPECT_FALSE(missed.is_inside);

    const SphereTest& struck = told.parts[1];
    EXPECT_EQ(struck.sphere, (BoundingSphere{{2, 0, 0}, 1}));
    EXPECT_EQ(struck.distance, 0.5);
    EXPECT_EQ(struck.depth, 0.5);
    EXPECT_EQ(struck.parameter, 0.5);
    EXPECT_TRUE(struck.is_inside);
    EXPECT_EQ(told.hits, parts({1}));
}

TEST(SphereHierarchyTest, AnExplanationOfAPointHasThePointItself)
{
    const SphereTest root = pair().explain(Query::point({0, 1, 2})).root;
    EXPECT_EQ(root.closest_point, glm::dvec3(0, 1, 2));
    EXPECT_EQ(root.parameter, 0);
    EXPECT_DOUBLE_EQ(root.distance, std::sqrt(5.0));
}

TEST(SphereHierarchyTest, APointExactlyOnASphereIsInside)
{
    const SphereHierarchy hierarchy = pair();
    // On the part's sphere and where the root touches it.
    for (const glm::dvec3& point : {glm::dvec3(3, 0, 0), glm::dvec3(2, 1, 0), glm::dvec3(1, 0, 0)}) {
        EXPECT_EQ(hierarchy.hit_test(Query::point(point)).parts, parts({1}));
        const Explanation told = hierarchy.explain(Query::point(point));
        EXPECT_EQ(told.parts.at(1).depth, 0);
        EXPECT_TRUE(told.parts.at(1).is_inside);
    }
    EXPECT_TRUE(hierarchy.hit_test(Query::point({3 + 1e-12, 0, 0})).parts.is_empty());
    EXPECT_TRUE(hierarchy.hit_test(Query::point({2, 1 + 1e-12, 0})).parts.is_empty());
}

TEST(SphereHierarchyTest, ATangentTouches)
{
    const SphereHierarchy hierarchy = pair();
    EXPECT_EQ(hierarchy.hit_test(Query::segment({-9, 1, 0}, {9, 1, 0})).parts, parts({0, 1}));
    EXPECT_EQ(hierarchy.hit_test(Query::ray({-9, 1, 0}, {0.1, 0, 0})).parts, parts({0, 1}));
    EXPECT_EQ(hierarchy.hit_test(Query::line({50, 1, 0}, {7, 0, 0})).parts, parts({0, 1}));
    EXPECT_TRUE(hierarchy.hit_test(Query::line({50, 1 + 1e-9, 0}, {7, 0, 0})).parts.is_empty());
    // Of the root as well, where it touches the part.
    EXPECT_EQ(hierarchy.hit_test(Query::segment({3, -9, 0}, {3, 9, 0})).parts, parts({1}));
    EXPECT_EQ(hierarchy.hit_test(Query::line({-3, 1, 1}, {0, 5, 5})).parts, parts({0}));
}

TEST(SphereHierarchyTest, ASegmentHasEnds)
{
    const SphereHierarchy hierarchy = pair();
    EXPECT_EQ(hierarchy.hit_test(Query::segment({9, 0, 0}, {3, 0, 0})).parts, parts({1}));
    EXPECT_TRUE(hierarchy.hit_test(Query::segment({9, 0, 0}, {3.01, 0, 0})).parts.is_empty());
    EXPECT_FALSE(hierarchy.hit_test(Query::segment({9, 0, 0}, {3.01, 0, 0})).is_root_entered);
    EXPECT_TRUE(hierarchy.hit_test(Query::segment({-0.99, 0, 0}, {0.99, 0, 0})).parts.is_empty());
    EXPECT_EQ(hierarchy.hit_test(Query::segment({-1, 0, 0}, {0.99, 0, 0})).parts, parts({0}));
    EXPECT_EQ(hierarchy.hit_test(Query::segment({2, 0, 0}, {2.1, 0, 0})).parts, parts({1})); // within it
    EXPECT_EQ(hierarchy.explain(Query::segment({9, 0, 0}, {3, 0, 0})).parts.at(1).parameter, 1);
}

TEST(SphereHierarchyTest, ASegmentWithoutLengthIsAPoint)
{
    const SphereHierarchy hierarchy = pair();
    for (const glm::dvec3& point : {glm::dvec3(3, 0, 0), glm::dvec3(2, 0, 0), glm::dvec3(0, 1, 0),
                                    glm::dvec3(3.01, 0, 0), glm::dvec3(2, 1, 0)}) {
        const HitResult expected = hierarchy.hit_test(Query::point(point));
        EXPECT_EQ(hierarchy.hit_test(Query::segment(point, point)), expected);
        EXPECT_EQ(hierarchy.hit_test(Query::ray(point, {})), expected);
        EXPECT_EQ(hierarchy.hit_test(Query::line(point, {})), expected);
    }
}

TEST(SphereHierarchyTest, ARayHitsNothingBehindIt)
{
    const SphereHierarchy hierarchy = pair();
    EXPECT_EQ(hierarchy.hit_test(Query::ray({0, 0, 0}, {1, 0, 0})).parts, parts({1}));
    EXPECT_EQ(hierarchy.hit_test(Query::ray({0, 0, 0}, {-1, 0, 0})).parts, parts({0}));
    EXPECT_TRUE(hierarchy.hit_test(Query::ray({4, 0, 0}, {1, 0, 0})).parts.is_empty());
    EXPECT_FALSE(hierarchy.hit_test(Query::ray({4, 0, 0}, {1, 0, 0})).is_root_entered);
    EXPECT_EQ(hierarchy.hit_test(Query::ray({4, 0, 0}, {-1e-3, 0, 0})).parts, parts({0, 1}));
    const SphereTest behind = hierarchy.explain(Query::ray({0, 0, 0}, {1, 0, 0})).parts.at(0);
    EXPECT_EQ(behind.closest_point, glm::dvec3(0));
    EXPECT_EQ(behind.parameter, 0);
    EXPECT_EQ(behind.distance, 2);
    EXPECT_EQ(behind.depth, -1);
}

TEST(SphereHierarchyTest, ALineThroughTheCentreIsAsDeepAsTheRadius)
{
    const SphereHierarchy hierarchy = pair();
    const SphereTest test = hierarchy.explain(Query::line({2, 5, 0}, {0, 10, 0})).parts.at(1);
    EXPECT_EQ(test.distance, 0);
    EXPECT_EQ(test.depth, 1);
    EXPECT_EQ(test.parameter, -0.5);
    EXPECT_EQ(test.closest_point, glm::dvec3(2, 0, 0));
}

TEST(SphereHierarchyTest, AThickQueryReachesFurther)
{
    const SphereHierarchy hierarchy = pair();
    EXPECT_TRUE(hierarchy.hit_test(Query::point({2, 1.5, 0})).parts.is_empty());
    EXPECT_EQ(hierarchy.hit_test(Query::point({2, 1.5, 0}, 0.5)).parts, parts({1})); // touches
    EXPECT_TRUE(hierarchy.hit_test(Query::point({2, 1.5, 0}, 0.4999)).parts.is_empty());
    EXPECT_EQ(hierarchy.hit_test(Query::point({4, 0, 0}, 1)).parts, parts({1})); // its centre out of the root
    EXPECT_EQ(hierarchy.hit_test(Query::segment({-9, 1.25, 0}, {-2, 1.25, 0}, 0.25)).parts, parts({0}));
    const SphereTest test = hierarchy.explain(Query::point({2, 1.25, 0}, 0.5)).parts.at(1);
    EXPECT_EQ(test.distance, 1.25);
    EXPECT_EQ(test.depth, 0.25);
}

TEST(SphereHierarchyTest, APartIsHitWhicheverItHangsOn)
{
    // A long gun whose sphere is out of the turret's that carries it.
    const std::vector<BoundingSphere> local{{{0, 0, 0}, 2}, {{0, 0, 0}, 1}, {{0, 0, 3}, 0.5}};
    SphereHierarchy hierarchy(local);
    EXPECT_EQ(hierarchy.hit_test(Query::point({0, 0, 3})).parts, parts({2}));
    EXPECT_EQ(hierarchy.hit_test(Query::segment({0, 0, -9}, {0, 0, 9})).parts, parts({0, 1, 2}));
}

TEST(SphereHierarchyTest, SpheresFollowTheirMatrices)
{
    SphereHierarchy hierarchy = pair();
    const std::vector<glm::mat4> matrices{at(0, 0, 0), at(10, 0, 0)};
    hierarchy.refit(matrices);
    EXPECT_EQ(hierarchy.parts()[1], (BoundingSphere{{12, 0, 0}, 1}));
    EXPECT_EQ(hierarchy.root().centre, glm::dvec3(5, 0, 0));
    EXPECT_NEAR(hierarchy.root().radius, 8, MARGIN);
    EXPECT_TRUE(hierarchy.hit_test(Query::point({2, 0, 0})).parts.is_empty());
    EXPECT_EQ(hierarchy.hit_test(Query::point({12, 0, 0})).parts, parts({1}));
}

TEST(SphereHierarchyTest, OnlyWhatHasMovedIsRefitted)
{
    SphereHierarchy hierarchy = pair();
    EXPECT_EQ(hierarchy.refit_counts().parts, 0u);
    EXPECT_EQ(hierarchy.refit_counts().roots, 0u);
    std::vector<glm::mat4> matrices{at(0, 0, 0), at(0, 0, 0)};
    hierarchy.refit(matrices); // where they are already
    EXPECT_EQ(hierarchy.refit_counts().parts, 0u);
    EXPECT_EQ(hierarchy.refit_counts().roots, 0u);
    matrices[1] = at(1, 0, 0);
    hierarchy.refit(matrices);
    EXPECT_EQ(hierarchy.refit_counts().parts, 1u);
    EXPECT_EQ(hierarchy.refit_counts().roots, 1u);
    for (int i = 0; i < 10; ++i) {
        hierarchy.refit(matrices);
    }
    EXPECT_EQ(hierarchy.refit_counts().parts, 1u);
    EXPECT_EQ(hierarchy.refit_counts().roots, 1u);
    matrices = {at(0, 1, 0), at(1, 1, 0)};
    hierarchy.refit(matrices);
    EXPECT_EQ(hierarchy.refit_counts().parts, 3u);
    EXPECT_EQ(hierarchy.refit_counts().roots, 2u);
}

TEST(SphereHierarchyTest, AWheelThatRollsInPlaceLeavesTheRootAlone)
{
    const std::vector<BoundingSphere> local{{{0, 0, 0}, 1}, {{3, 0, 0}, 1}};
    SphereHierarchy hierarchy(local);
    const glm::mat4 quarter_turn({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    const std::vector<glm::mat4> matrices{quarter_turn, at(0, 0, 0)};
    hierarchy.refit(matrices);
    EXPECT_EQ(hierarchy.refit_counts().parts, 1u);
    EXPECT_EQ(hierarchy.refit_counts().roots, 0u);
}

TEST(SphereHierarchyTest, TheLabsSphereOfTheWholeIsCarriedAlong)
{
    SphereHierarchy hierarchy = pair();
    EXPECT_TRUE(hierarchy.whole().is_empty());
    hierarchy.carry_whole({{0, 1, 0}, 5}, 0);
    EXPECT_EQ(hierarchy.whole(), (BoundingSphere{{0, 1, 0}, 5}));
    const std::vector<glm::mat4> matrices{at(0, 0, 7), at(100, 0, 0)};
    hierarchy.refit(matrices);
    EXPECT_EQ(hierarchy.whole(), (BoundingSphere{{0, 1, 7}, 5})); // with part 0, not with part 1
    hierarchy.carry_whole({{0, 1, 0}, 6}, 1);                     // set where the parts are now
    EXPECT_EQ(hierarchy.whole(), (BoundingSphere{{100, 1, 0}, 6}));
    // It takes no part in tests.
    EXPECT_TRUE(hierarchy.whole().contains({105, 1, 0}));
    EXPECT_FALSE(hierarchy.hit_test(Query::point({105, 1, 0})).is_root_entered);
}

TEST(SphereHierarchyTest, EmptySpheresAreNeverHit)
{
    const std::vector<BoundingSphere> local{{}, {{2, 0, 0}, 1}, {}};
    SphereHierarchy hierarchy(local);
    EXPECT_NEAR(hierarchy.root().radius, 1, MARGIN);
    const std::vector<glm::mat4> matrices{at(0, 0, 0), at(0, 0, 0), at(2, 0, 0)};
    hierarchy.refit(matrices);
    for (const double radius : {0.0, 0.5, 1.0, 100.0}) {
        const Query query = Query::point({2, 0, 0}, radius);
        EXPECT_EQ(hierarchy.hit_test(query).parts, parts({1})) << radius;
        const Explanation told = hierarchy.explain(query);
        EXPECT_EQ(told.hits, parts({1}));
        EXPECT_LT(told.parts.at(2).depth, 0);
    }
}

TEST(SphereHierarchyTest, WithoutPartsNothingIsHit)
{
    SphereHierarchy none;
    const std::vector<BoundingSphere> local(3);
    SphereHierarchy only_empty(local);
    none.refit({});
    for (const SphereHierarchy* hierarchy : {&none, &only_empty}) {
        EXPECT_TRUE(hierarchy->root().is_empty());
        for (const Query& query : {Query::point({}), Query::point({}, 9), Query::line({}, {1, 0, 0}, 9)}) {
            EXPECT_EQ(hierarchy->hit_test(query), HitResult{});
            EXPECT_FALSE(hierarchy->explain(query).root.is_inside);
            EXPECT_LT(hierarchy->explain(query).root.depth, 0);
            EXPECT_TRUE(hierarchy->explain(query).parts.empty());
        }
    }
}

TEST(SphereHierarchyTest, SixtyFourPartsAreAsGoodAsTwo)
{
    std::vector<BoundingSphere> local;
    for (std::size_t i = 0; i < MAX_PARTS; ++i) {
        local.push_back({{static_cast<double>(i), 0, 0}, 0.25});
    }
    const SphereHierarchy hierarchy(local);
    EXPECT_EQ(hierarchy.hit_test(Query::line({}, {1, 0, 0})).parts.count(), 64);
    EXPECT_EQ(hierarchy.hit_test(Query::point({63.25, 0, 0})).parts, parts({63}));
    EXPECT_EQ(hierarchy.explain(Query::point({63.25, 0, 0})).hits, parts({63}));
}

TEST(SphereHierarchyTest, BadQueriesAreRefusedAndHitNothing)
{
    const SphereHierarchy hierarchy = pair();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Query through = Query::segment({-9, 0, 0}, {9, 0, 0}, nan);
    EXPECT_EQ(hierarchy.hit_test(through), (HitResult{Refusal::not_finite, false, {}}));
    EXPECT_EQ(hierarchy.hit_test(Query::point({nan, 0, 0})).refusal, Refusal::not_finite);
    EXPECT_EQ(hierarchy.hit_test(Query::point({1e200, 0, 0})).refusal, Refusal::too_far);
    EXPECT_EQ(hierarchy.hit_test(Query::point({2, 0, 0}, -0.5)).refusal, Refusal::negative_radius);
    const Explanation told = hierarchy.explain(through);
    EXPECT_EQ(told.refusal, Refusal::not_finite);
    EXPECT_TRUE(told.parts.empty());
    EXPECT_TRUE(told.hits.is_empty());
    EXPECT_FALSE(told.root.is_inside);
}

} // namespace
} // namespace collision
