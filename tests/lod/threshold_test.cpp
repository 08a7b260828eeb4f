#include "lod/threshold.h"

#include <gtest/gtest.h>
#include <limits>

namespace lod {
namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

TEST(ThresholdTest, ABandIsAsWideAsAsked)
{
    EXPECT_DOUBLE_EQ(band_by_fraction(100.0).inner, 98.0);
    EXPECT_DOUBLE_EQ(band_by_fraction(100.0).outer, 102.0);
    EXPECT_DOUBLE_EQ(band_by_fraction(80.0, 0.25).inner, 60.0);
    EXPECT_DOUBLE_EQ(band_by_fraction(80.0, 0.25).outer, 100.0);
}

TEST(ThresholdTest, ABandNeverTurnsAroundNorBelowNothing)
{
    for (const double bad : {-1.0, NOT_A_NUMBER, 0.0, -INFINITE}) {
        EXPECT_EQ(band_by_fraction(80.0, bad).inner, 80.0) << bad;
        EXPECT_EQ(band_by_fraction(80.0, bad).outer, 80.0) << bad;
    }
    EXPECT_EQ(band_by_fraction(80.0, 7.0).inner, 0.0);
    EXPECT_EQ(band_by_fraction(80.0, 7.0).outer, 160.0);
}

} // namespace
} // namespace lod
