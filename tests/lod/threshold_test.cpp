#include "lod/threshold.h"

#include <gtest/gtest.h>
#include <limits>

namespace lod {
namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

TEST(ThresholdTest, AGoodOneIsTakenAsItIs)
{
    for (const double wanted : {1.0, 1.5, 100.0, 1e6}) {
        const CheckedThreshold checked = checked_threshold(wanted, 1.0, 50.0);
        EXPECT_EQ(checked.distance, wanted);
        EXPECT_EQ(checked.fault, ThresholdFault::none);
    }
    EXPECT_EQ(threshold_fault_text(ThresholdFault::none), "");
}

TEST(ThresholdTest, OneBelowTheNearPlaneIsBroughtThereAndSaysSo)
{
    for (const double wanted : {0.999, 0.0, -0.0, -5.0, -1e300}) {
        const CheckedThreshold checked = checked_threshold(wanted, 1.0, 50.0);
        EXPECT_EQ(checked.distance, 1.0) << wanted;
        EXPECT_EQ(checked.fault, ThresholdFault::below_near_plane) << wanted;
    }
    EXPECT_NE(threshold_fault_text(ThresholdFault::below_near_plane), "");
}

TEST(ThresholdTest, WhatIsNotFiniteIsRefusedAndSaysSo)
{
    for (const double wanted : {NOT_A_NUMBER, INFINITE, -INFINITE}) {
        const CheckedThreshold checked = checked_threshold(wanted, 1.0, 50.0);
        EXPECT_EQ(checked.distance, 50.0) << wanted;
        EXPECT_EQ(checked.fault, ThresholdFault::not_finite) << wanted;
    }
    EXPECT_NE(threshold_fault_text(ThresholdFault::not_finite), "");
}

TEST(ThresholdTest, ABandIsAsWideAsAsked)
{
    EXPECT_DOUBLE_EQ(band_by_fraction(100.0).inner, 98.0);
    EXPECT_DOUBLE_EQ(band_by_fraction(100.0).outer, 102.0);
    EXPECT_DOUBLE_EQ(band_by_fraction(80.0, 0.25).inner, 60.0);
    EXPECT_DOUBLE_EQ(band_by_fraction(80.0, 0.25).outer, 100.0);
    EXPECT_DOUBLE_EQ(band_by_metres(80.0, 3.0).inner, 77.0);
    EXPECT_DOUBLE_EQ(band_by_metres(80.0, 3.0).outer, 83.0);
}

TEST(ThresholdTest, ABandNeverTurnsAroundNorBelowNothing)
{
    for (const double bad : {-1.0, NOT_A_NUMBER, 0.0, -INFINITE}) {
        EXPECT_EQ(band_by_fraction(80.0, bad).inner, 80.0) << bad;
        EXPECT_EQ(band_by_fraction(80.0, bad).outer, 80.0) << bad;
        EXPECT_EQ(band_by_metres(80.0, bad).inner, 80.0) << bad;
        EXPECT_EQ(band_by_metres(80.0, bad).outer, 80.0) << bad;
    }
    EXPECT_EQ(band_by_fraction(80.0, 7.0).inner, 0.0);
    EXPECT_EQ(band_by_fraction(80.0, 7.0).outer, 160.0);
    EXPECT_EQ(band_by_metres(80.0, 100.0).inner, 0.0);
}

} // namespace
} // namespace lod
