#include "particles/colour_table.h"

#include <gtest/gtest.h>

namespace particles {
namespace {

TEST(ColourTable, BeginsWithTheStartAndEndsWithTheEnd)
{
    const ColourTable table = colour_table({.start = {1.0f, 0.0f, 0.5f, 1.0f},
                                            .middle = {0.0f, 1.0f, 0.0f, 1.0f},
                                            .end = {0.25f, 0.0f, 1.0f, 0.0f},
                                            .middle_at = 0.4f});
    EXPECT_EQ(table.front(), (Rgba{255, 0, 128, 255}));
    EXPECT_EQ(table[102], (Rgba{0, 255, 0, 255})); // 0.4 * 255
    EXPECT_EQ(table.back(), (Rgba{64, 0, 255, 0}));
}

TEST(ColourTable, GoesStraightInBetween)
{
    const ColourTable table = colour_table({.start = {0.0f, 0.0f, 0.0f, 1.0f},
                                            .middle = {1.0f, 1.0f, 1.0f, 1.0f},
                                            .end = {0.0f, 0.0f, 0.0f, 1.0f},
                                            .middle_at = 0.5f});
    EXPECT_NEAR(table[64].red, 128, 1);
    EXPECT_NEAR(table[191].red, 128, 1);
    for (std::size_t i = 1; i < 127; ++i) {
        EXPECT_GE(table[i].red, table[i - 1].red);
        EXPECT_LE(table[i + 128].red, table[i + 127].red);
    }
}

TEST(ColourTable, WithTheMiddleAtEitherEndHasNoWayToOrFromIt)
{
    ColourRamp ramp{.start = {1.0f, 0.0f, 0.0f, 1.0f},
                    .middle = {0.0f, 1.0f, 0.0f, 1.0f},
                    .end = {0.0f, 0.0f, 1.0f, 1.0f},
                    .middle_at = 0.0f};
    EXPECT_EQ(colour_table(ramp).front(), (Rgba{0, 255, 0, 255}));
    EXPECT_EQ(colour_table(ramp).back(), (Rgba{0, 0, 255, 255}));
    ramp.middle_at = 1.0f;
    EXPECT_EQ(colour_table(ramp).front(), (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(colour_table(ramp).back(), (Rgba{0, 255, 0, 255}));
}

} // namespace
} // namespace particles
