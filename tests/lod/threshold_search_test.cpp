#include "lod/threshold_search.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace lod {
namespace {

const ShowingCriterion CRITERION{.tolerance = 12, .share = 0.05, .pixels = 0};

PictureDifference difference(bool is_shown)
{
    return {.tank_pixels = 1000, .differing = is_shown ? 51u : 50u, .largest = 200};
}

TEST(ThresholdSearchTest, FindsAnyEdgeToTheResolution)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
        const double edge = 5.0 + 900.0 * static_cast<double>(random() >> 11) * 0x1p-53;
        int asked = 0;
        const auto measure = [&](double distance) {
            ++asked;
            return difference(distance < edge);
        };
        const SearchRange range{.nearest = 2, .furthest = 1000, .ratio = 1.1, .resolution = 0.01};
        const ThresholdResult result = find_threshold(range, CRITERION, measure);
        ASSERT_EQ(result.outcome, ThresholdOutcome::found);
        ASSERT_GE(result.distance, edge);
        ASSERT_LE(result.distance, edge + 0.01);
        ASSERT_LT(asked, 100);
    }
}

TEST(ThresholdSearchTest, ADifferenceThatComesBackFurtherAwayDecides)
{
    // Shows up to 40, and again from 100 to 130.
    const auto measure = [](double distance) {
        return difference(distance < 40 || (distance > 100 && distance < 130));
    };
    const ThresholdResult result = find_threshold(
        {.nearest = 5, .furthest = 400, .ratio = 1.05, .resolution = 0.001}, CRITERION, measure);
    EXPECT_EQ(result.outcome, ThresholdOutcome::found);
    EXPECT_NEAR(result.distance, 130, 0.001);
}

TEST(ThresholdSearchTest, ItSaysWhenThereIsNone)
{
    const SearchRange range{.nearest = 5, .furthest = 400};
    const auto always = [](double) { return difference(true); };
    const auto never = [](double) { return difference(false); };
    EXPECT_EQ(find_threshold(range, CRITERION, always),
              (ThresholdResult{ThresholdOutcome::shows_everywhere, 0}));
    EXPECT_EQ(find_threshold(range, CRITERION, never), (ThresholdResult{ThresholdOutcome::shows_nowhere, 5}));
    const auto at_nearest = [](double distance) { return difference(distance <= 5); };
    EXPECT_EQ(find_threshold(range, CRITERION, at_nearest).outcome, ThresholdOutcome::found);
}

TEST(ThresholdSearchTest, GoesFromAfarInwardsWithinTheRangeOneDistanceAtATime)
{
    ThresholdSearch search({.nearest = 10, .furthest = 100, .ratio = 2, .resolution = 5}, CRITERION);
    std::vector<double> asked;
    while (const auto distance = search.next_distance()) {
        EXPECT_EQ(search.next_distance(), distance); // asking twice asks the same
        EXPECT_EQ(search.result().outcome, ThresholdOutcome::searching);
        asked.push_back(*distance);
        search.report(difference(*distance < 30));
    }
    EXPECT_EQ(asked, (std::vector<double>{100, 50, 25, 37.5, 31.25, 28.125}));
    EXPECT_EQ(search.result(), (ThresholdResult{ThresholdOutcome::found, 31.25}));
    search.report(difference(true)); // too late
    EXPECT_EQ(search.result(), (ThresholdResult{ThresholdOutcome::found, 31.25}));
}

TEST(ThresholdSearchTest, OddRangesComeToAnEnd)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SearchRange& range :
         {SearchRange{.nearest = 10, .furthest = 10}, SearchRange{.nearest = 10, .furthest = 5},
          SearchRange{.nearest = 10, .furthest = 100, .ratio = 1},
          SearchRange{.nearest = 10, .furthest = 100, .ratio = nan},
          SearchRange{.nearest = 10, .furthest = 100, .ratio = 1.1, .resolution = 0},
          SearchRange{.nearest = 10, .furthest = 100, .ratio = 1.1, .resolution = nan},
          SearchRange{.nearest = nan, .furthest = nan}}) {
        for (const double edge : {0.0, 9.0, 10.5, 50.0, 1000.0}) {
            int asked = 0;
            ThresholdSearch search(range, CRITERION);
            while (const auto distance = search.next_distance()) {
                ASSERT_LT(++asked, 1000);
                search.report(difference(*distance < edge));
            }
        }
    }
}

} // namespace
} // namespace lod
