#include "collision/query.h"

#include <gtest/gtest.h>
#include <limits>

namespace collision {
namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

TEST(QueryTest, GoodQueriesAreNotRefused)
{
    EXPECT_EQ(refusal_of(Query::point({1, 2, 3})), Refusal::none);
    EXPECT_EQ(refusal_of(Query::point({1e6, -1e6, MAX_COORDINATE}, 0.01)), Refusal::none);
    EXPECT_EQ(refusal_of(Query::segment({1e6, 0, 0}, {-1e6, 0, 0}, 1)), Refusal::none);
    EXPECT_EQ(refusal_of(Query::segment(glm::dvec3(MAX_COORDINATE), glm::dvec3(-MAX_COORDINATE))),
              Refusal::none);
    EXPECT_EQ(refusal_of(Query::segment({1, 1, 1}, {1, 1, 1})), Refusal::none);
    EXPECT_EQ(refusal_of(Query::ray({0, 0, 0}, {0, 0, 0})), Refusal::none);
    EXPECT_EQ(refusal_of(Query::line({0, 0, 0}, {0, 0, -1})), Refusal::none);
}

TEST(QueryTest, WhatIsNotFiniteIsRefusedWhereverItStands)
{
    for (const double bad : {NOT_A_NUMBER, INFINITE, -INFINITE}) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 v(0);
            v[axis] = bad;
            const glm::dvec3 good(1, 2, 3);
            for (const Query& query : {Query::point(v), Query::point(v, 1), Query::segment(v, good),
                                       Query::segment(good, v), Query::segment(v, v), Query::ray(v, good),
                                       Query::ray(good, v), Query::line(v, good), Query::line(good, v)}) {
                EXPECT_EQ(refusal_of(query), Refusal::not_finite) << bad << axis;
            }
        }
        EXPECT_EQ(refusal_of(Query::point({0, 0, 0}, bad)), Refusal::not_finite) << bad;
    }
}

TEST(QueryTest, WhatIsTooFarOrNegativeIsRefused)
{
    const double far = 1.001 * MAX_COORDINATE;
    for (const Query& query :
         {Query::point({0, far, 0}), Query::point({0, 0, -1e300}), Query::segment({0, far, 0}, {}),
          Query::segment({}, {0, far, 0}), Query::ray({}, {far, 0, 0}), Query::line({far, 0, 0}, {1, 0, 0}),
          Query::point({0, 0, 0}, far)}) {
        EXPECT_EQ(refusal_of(query), Refusal::too_far);
    }
    EXPECT_EQ(refusal_of(Query::point({0, 0, 0}, -1e-300)), Refusal::negative_radius);
    EXPECT_EQ(refusal_of(Query::point({0, 0, 0}, -0.0)), Refusal::none);
}

TEST(QueryTest, EveryRefusalSaysWhy)
{
    EXPECT_EQ(refusal_text(Refusal::none), "");
    for (const Refusal refusal : {Refusal::not_finite, Refusal::too_far, Refusal::negative_radius}) {
        EXPECT_GT(refusal_text(refusal).size(), 10u);
    }
}

} // namespace
} // namespace collision
