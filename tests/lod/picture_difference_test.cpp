#include "lod/picture_difference.h"

#include <gtest/gtest.h>
#include <vector>

namespace lod {
namespace {

/// A picture of one colour that owns its pixels.
struct Canvas
{
    int width;
    int height;
    std::vector<std::uint8_t> rgba;

    Canvas(int w, int h, std::uint8_t grey, std::uint8_t alpha = 255) : width(w), height(h)
    {
        for (int i = 0; i < w * h; ++i) {
            rgba.insert(rgba.end(), {grey, grey, grey, alpha});
        }
    }

    std::uint8_t* at(int pixel) { return rgba.data() + 4 * pixel; }
    Picture picture() const { return {width, height, rgba}; }
};

TEST(PictureDifferenceTest, EqualPicturesDoNotDiffer)
{
    const Canvas empty(4, 3, 100);
    Canvas tank = empty;
    tank.at(5)[0] = 7;
    tank.at(6)[2] = 101;
    const auto difference = measure_difference(tank.picture(), tank.picture(), empty.picture(), 0);
    ASSERT_TRUE(difference);
    EXPECT_EQ(*difference, (PictureDifference{.tank_pixels = 2, .differing = 0, .largest = 0}));
    EXPECT_EQ(difference->share(), 0.0);
}

TEST(PictureDifferenceTest, PixelsBeyondTheToleranceAreCounted)
{
    const Canvas empty(4, 3, 100);
    Canvas high = empty;
    Canvas low = empty;
    high.at(0)[0] = 110; // 10 more red
    high.at(1)[1] = 111; // 11 more green
    low.at(2)[2] = 60;   // 40 less blue
    high.at(3)[0] = 50;  // in both
    low.at(3)[0] = 50;
    const auto difference = measure_difference(high.picture(), low.picture(), empty.picture(), 10);
    ASSERT_TRUE(difference);
    EXPECT_EQ(*difference, (PictureDifference{.tank_pixels = 4, .differing = 2, .largest = 40}));
    EXPECT_EQ(difference->share(), 0.5);
    EXPECT_EQ(measure_difference(low.picture(), high.picture(), empty.picture(), 10), difference);
}

TEST(PictureDifferenceTest, AlphaIsNoColourButCanTellTheTank)
{
    Canvas high(4, 1, 100, 0);
    Canvas low(4, 1, 100, 0);
    high.at(0)[3] = 255;
    low.at(1)[3] = 1;
    low.at(1)[0] = 120;
    const auto difference = measure_difference(high.picture(), low.picture(), 5);
    ASSERT_TRUE(difference);
    EXPECT_EQ(*difference, (PictureDifference{.tank_pixels = 2, .differing = 1, .largest = 20}));
    const Canvas empty(4, 1, 100, 77);
    EXPECT_EQ(measure_difference(high.picture(), low.picture(), empty.picture(), 5)->tank_pixels, 1u);
}

TEST(PictureDifferenceTest, NoTankIsNoDifference)
{
    const Canvas empty(4, 3, 100);
    EXPECT_EQ(measure_difference(empty.picture(), empty.picture(), empty.picture(), 0)->share(), 0.0);
    const Canvas none(0, 0, 0);
    EXPECT_EQ(measure_difference(none.picture(), none.picture(), 0), PictureDifference{});
}

TEST(PictureDifferenceTest, PicturesThatDoNotFitAreRefused)
{
    const Canvas one(4, 3, 100);
    const Canvas turned(3, 4, 100);
    Canvas cut = one;
    cut.rgba.pop_back();
    Canvas negative = one;
    negative.width = -4;
    negative.height = -3;
    for (const Canvas& bad : {turned, cut, negative}) {
        EXPECT_FALSE(measure_difference(bad.picture(), one.picture(), one.picture(), 0));
        EXPECT_FALSE(measure_difference(one.picture(), bad.picture(), one.picture(), 0));
        EXPECT_FALSE(measure_difference(one.picture(), one.picture(), bad.picture(), 0));
        EXPECT_FALSE(measure_difference(bad.picture(), one.picture(), 0));
        EXPECT_FALSE(measure_difference(one.picture(), bad.picture(), 0));
    }
    EXPECT_FALSE(measure_difference(cut.picture(), cut.picture(), 0));
}

TEST(PictureDifferenceTest, ADifferenceShowsBeyondAShareOfTheTankAndAFewPixels)
{
    const ShowingCriterion criterion{.tolerance = 12, .share = 0.05, .pixels = 2};
    EXPECT_FALSE(shows({.tank_pixels = 100, .differing = 5, .largest = 255}, criterion));
    EXPECT_TRUE(shows({.tank_pixels = 100, .differing = 6, .largest = 13}, criterion));
    EXPECT_FALSE(shows({.tank_pixels = 4, .differing = 2, .largest = 255}, criterion));
    EXPECT_TRUE(shows({.tank_pixels = 4, .differing = 3, .largest = 255}, criterion));
    EXPECT_FALSE(shows({}, criterion));
    EXPECT_TRUE(
        shows({.tank_pixels = 100, .differing = 1, .largest = 1}, {.tolerance = 0, .share = 0, .pixels = 0}));
}

TEST(PictureDifferenceTest, ByACriterionCountsPatches)
{
    // 4 x 2 pixels, patches of 2 x 2: in the left one single pixels differ and cancel out, the right one is
    // another in all.
    const auto grey = [](std::initializer_list<std::uint8_t> values) {
        std::vector<std::uint8_t> rgba;
        for (std::uint8_t value : values) {
            rgba.insert(rgba.end(), {value, value, value, 255});
        }
        return rgba;
    };
    const auto high = grey({0, 200, 50, 50, 200, 0, 50, 50});
    const auto low = grey({200, 0, 90, 90, 0, 200, 90, 90});
    const auto none = grey({250, 250, 50, 50, 250, 250, 50, 50});
    const ShowingCriterion criterion{.patch = 2, .tolerance = 30};
    EXPECT_EQ(measure_difference({4, 2, high}, {4, 2, low}, {4, 2, none}, criterion),
              (PictureDifference{.tank_pixels = 2, .differing = 1, .largest = 40}));
    EXPECT_FALSE(measure_difference({4, 3, high}, {4, 2, low}, {4, 2, none}, criterion));
}

} // namespace
} // namespace lod
