// How the values of pixels become bytes.

#include "legacygl/pixel/pixel_format.h"

#include <gtest/gtest.h>

using namespace legacygl;

TEST(PixelFormat, RepeatsTheBitsOfAShortFraction)
{
    EXPECT_EQ(byte_of_bits(1, 1), 255);
    EXPECT_EQ(byte_of_bits(2, 2), 0b10101010);
    EXPECT_EQ(byte_of_bits(3, 3), 0b01101101);
    EXPECT_EQ(byte_of_bits(9, 4), 0b10011001);
    EXPECT_EQ(byte_of_bits(3, 5), 0b00011000); // 24, where 25 is nearer.
    EXPECT_EQ(byte_of_bits(28, 5), 0b11100111);
    EXPECT_EQ(byte_of_bits(13, 6), 0b00110100); // 52, where 53 is nearer.
}

TEST(PixelFormat, KeepsBytesAndRoundsLongerFractions)
{
    EXPECT_EQ(byte_of_bits(77, 8), 77);
    EXPECT_EQ(byte_of_bits(1023, 10), 255);
    EXPECT_EQ(byte_of_bits(511, 10), 127);
    EXPECT_EQ(byte_of_bits(513, 10), 128);
}
