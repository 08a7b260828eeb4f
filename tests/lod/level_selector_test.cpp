#include "lod/level_selector.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace lod {
namespace {

constexpr double D = 120.0;

/// Moves through the distances and counts the switches; each has to be to the other level.
int switches(LevelSelector& selector, const std::vector<double>& distances, const SwitchBand& band)
{
    int count = 0;
    for (const double distance : distances) {
        const Level before = selector.level;
        const bool switched = selector.update(distance, band);
        EXPECT_EQ(switched, selector.level != before);
        count += switched ? 1 : 0;
    }
    return count;
}

TEST(LevelSelectorTest, WithoutAPastTheThresholdAloneDecides)
{
    EXPECT_EQ(level_at(0.0, D), Level::high);
    EXPECT_EQ(level_at(D, D), Level::high);
    EXPECT_EQ(level_at(std::nextafter(D, 1e9), D), Level::low);
    EXPECT_EQ(level_at(-3.0, D), Level::high);
    EXPECT_EQ(level_at(std::numeric_limits<double>::infinity(), D), Level::low);
    EXPECT_EQ(level_at(std::numeric_limits<double>::quiet_NaN(), D), Level::high);
    LevelSelector selector{Level::high};
    selector.start(D + 1.0, D); // within the band: what was before does not count
    EXPECT_EQ(selector.level, Level::low);
}

TEST(LevelSelectorTest, BeyondTheBandItIsLowInsideItHighAndWithinItStays)
{
    const SwitchBand band = band_by_fraction(D);
    for (const Level current : {Level::high, Level::low}) {
        EXPECT_EQ(next_level(current, band.inner - 1e-9, band), Level::high);
        EXPECT_EQ(next_level(current, band.inner, band), current);
        EXPECT_EQ(next_level(current, D, band), current);
        EXPECT_EQ(next_level(current, band.outer, band), current);
        EXPECT_EQ(next_level(current, band.outer + 1e-9, band), Level::low);
        EXPECT_EQ(next_level(current, std::numeric_limits<double>::quiet_NaN(), band), current);
        EXPECT_EQ(next_level(current, -5.0, band), Level::high);
    }
}

TEST(LevelSelectorTest, EveryCrossingBothWaysAtManySpeedsSwitchesExactlyOnce)
{
    for (const double fraction : {0.0, 0.001, 0.02, 0.3}) {
        const SwitchBand band = band_by_fraction(D, fraction);
        for (const double speed : {0.0007, 0.01, 0.1, 1.0, 3.3, 17.0, 90.0, 150.0}) { // metres a step
            std::vector<double> outwards;
            const double margin = 0.4 * D * 0.1 + speed; // starts and ends outside of the band
            const double from = std::max(band.inner - (speed < 0.01 ? 0.5 : margin), 0.0);
            const double to = band.outer + (speed < 0.01 ? 0.5 : margin);
            for (double distance = from; distance < to; distance += speed) {
                outwards.push_back(distance);
            }
            outwards.push_back(to);
            const std::vector<double> inwards(outwards.rbegin(), outwards.rend());
            LevelSelector selector;
            for (int i = 0; i < 2; ++i) {
                ASSERT_EQ(switches(selector, outwards, band), 1) << fraction << " " << speed;
                ASSERT_EQ(selector.level, Level::low);
                ASSERT_EQ(switches(selector, inwards, band), 1) << fraction << " " << speed;
                ASSERT_EQ(selector.level, Level::high);
            }
        }
    }
}

TEST(LevelSelectorTest, NoTremblingWithinTheBandEverSwitches)
{
    const SwitchBand band = band_by_fraction(D);
    std::mt19937_64 random(1);
    for (const Level level : {Level::high, Level::low}) {
        LevelSelector selector{level};
        std::vector<double> distances;
        for (int i = 0; i < 100000; ++i) {
            const double fraction = static_cast<double>(random() >> 11) * 0x1p-53;
            distances.push_back(band.inner + fraction * (band.outer - band.inner));
        }
        distances.push_back(band.inner);
        distances.push_back(band.outer);
        EXPECT_EQ(switches(selector, distances, band), 0);
        EXPECT_EQ(selector.level, level);
    }
}

TEST(LevelSelectorTest, ACrossingThatTremblesSwitchesOnce)
{
    // A walk outwards that goes back by up to a band's width at every step.
    const SwitchBand band = band_by_fraction(D, 2.0 / D);
    std::mt19937_64 random(2);
    for (int walk = 0; walk < 300; ++walk) {
        std::vector<double> distances;
        for (double at = D - 10.0; at < D + 10.0; at += 0.05) {
            const double back = 3.9 * static_cast<double>(random() >> 11) * 0x1p-53;
            distances.push_back(at - back);
        }
        distances.push_back(D + 10.0);
        LevelSelector selector;
        ASSERT_EQ(switches(selector, distances, band), 1);
        ASSERT_EQ(selector.level, Level::low);
    }
}

TEST(LevelSelectorTest, BetweenTwoSwitchesLiesTheWholeBand)
{
    // Whatever the distances: that is what "no flicker" means.
    const SwitchBand band = band_by_fraction(D);
    std::mt19937_64 random(3);
    for (int walk = 0; walk < 100; ++walk) {
        LevelSelector selector;
        double at = D;
        int count = 0;
        for (int i = 0; i < 5000; ++i) {
            // Drawn back to D, so that it keeps crossing.
            at = D + 0.97 * (at - D) + 3.0 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1.0);
            if (selector.update(at, band)) {
                ++count;
                ASSERT_TRUE(selector.level == Level::low ? at > band.outer : at < band.inner);
            }
            ASSERT_TRUE(at <= band.outer || selector.level == Level::low);
            ASSERT_TRUE(at >= band.inner || selector.level == Level::high);
        }
        ASSERT_GT(count, 10);
    }
}

} // namespace
} // namespace lod
