#include "platform/files/png_file.h"

#include "image/image.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace {

TEST(PngFile, HoldsThePixelsWithTheFirstRowAtTheBottom)
{
    // Two columns, three rows, the bottom one first; alpha is anything.
    const std::vector<std::uint8_t> rgba = {1,  2,  3,  255, 4,  5,  6,  0,  7,  8,  9,  128,
                                            10, 11, 12, 1,   13, 14, 15, 77, 16, 17, 18, 2};
    platform_test::TemporaryFolder folder;
    const std::string path = folder.file("picture.png");
    ASSERT_EQ(platform::write_png(path, 2, 3, rgba), "");

    const std::string png = platform_test::read_file(path);
    const auto image =
        image::read_image(path, {reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
    ASSERT_TRUE(image);
    EXPECT_EQ(image.value().channels, 3);
    EXPECT_EQ(image.value().pixels, // read_image gives the bottom row first, too
              (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18}));
}

TEST(PngFile, SaysWhyItCannotBeWritten)
{
    const std::vector<std::uint8_t> rgba(4, 0);
    const std::string error = platform::write_png("/no/such/folder/picture.png", 1, 1, rgba);
    EXPECT_NE(error.find("/no/such/folder/picture.png"), std::string::npos);
    EXPECT_NE(error.find("No such file"), std::string::npos) << error;
}

} // namespace
