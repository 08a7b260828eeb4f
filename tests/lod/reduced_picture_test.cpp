#include "lod/reduced_picture.h"

#include <gtest/gtest.h>

namespace lod {
namespace {

TEST(ReducedPictureTest, IsTheRoundedAverageOfEachPatch)
{
    // 4 x 2 pixels; red counts up, green is 0 or 255, blue and alpha are the same everywhere.
    std::vector<std::uint8_t> rgba;
    for (std::uint8_t pixel = 0; pixel < 8; ++pixel) {
        const auto green = static_cast<std::uint8_t>(pixel % 2 == 0 ? 0 : 255);
        rgba.insert(rgba.end(), {pixel, green, 200, 255});
    }
    const ReducedPicture small = reduced({.width = 4, .height = 2, .rgba = rgba}, 2);
    EXPECT_EQ(small.width, 2);
    EXPECT_EQ(small.height, 1);
    // (0 + 1 + 4 + 5) / 4 = 2.5 and (2 + 3 + 6 + 7) / 4 = 4.5; 255 / 2 = 127.5: halves go up.
    EXPECT_EQ(small.rgba, (std::vector<std::uint8_t>{3, 128, 200, 255, 5, 128, 200, 255}));
}

TEST(ReducedPictureTest, LeavesOutWhatIsNoWholePatch)
{
    const std::vector<std::uint8_t> rgba(5 * 4 * 4, 7);
    const ReducedPicture small = reduced({.width = 5, .height = 4, .rgba = rgba}, 3);
    EXPECT_EQ(small.width, 1);
    EXPECT_EQ(small.height, 1);
    EXPECT_EQ(small.rgba, std::vector<std::uint8_t>(4, 7));
    EXPECT_EQ(reduced({.width = 5, .height = 4, .rgba = rgba}, 6).width, 0);
    EXPECT_TRUE(reduced({.width = 5, .height = 4, .rgba = rgba}, 6).rgba.empty());
}

TEST(ReducedPictureTest, ByOneIsThePictureItself)
{
    const std::vector<std::uint8_t> rgba = {1, 2, 3, 4, 5, 6, 7, 8};
    const ReducedPicture small = reduced({.width = 1, .height = 2, .rgba = rgba}, 1);
    EXPECT_EQ(small.rgba, rgba);
    EXPECT_EQ(small.view().width, 1);
    EXPECT_EQ(small.view().height, 2);
}

} // namespace
} // namespace lod
