#include "tests/image/read_image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using image::Image;

/// The pixel at (x, y), y counted from the top.
Bytes pixel_from_top(const Image& image, int x, int y)
{
    const auto at = image.pixels.begin() + long(((image.height - 1 - y) * image.width + x) * image.channels);
    return {at, at + image.channels};
}

/// Checks that the image is the picture upside down, in the picture's channels.
void expect_flipped(const Image& image, const Picture& picture)
{
    ASSERT_EQ(image.width, picture.width);
    ASSERT_EQ(image.height, picture.height);
    ASSERT_EQ(image.channels, picture.channels);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const auto at = picture.pixels.begin() + long((y * picture.width + x) * picture.channels);
            ASSERT_EQ(pixel_from_top(image, x, y), Bytes(at, at + picture.channels)) << x << ", " << y;
        }
    }
}

TEST(ReadImage, PutsTheBottomRowFirst)
{
    const Bytes red = {255, 0, 0};
    const Bytes blue = {0, 0, 255};
    const Image image = read(raw_png(1, 2, 8, 2, {red, blue}));
    EXPECT_EQ(image.pixels, (Bytes{0, 0, 255, 255, 0, 0}));
}

TEST(ReadImage, ReadsPng)
{
    for (const int channels : {3, 4}) {
        expect_flipped(read(png_file(sample_picture(13, 7, channels))), sample_picture(13, 7, channels));
    }
}

TEST(ReadImage, ReadsTgaPlainAndRunLengthEncoded)
{
    for (const int channels : {3, 4}) {
        for (const bool run_length_encoded : {false, true}) {
            Picture picture = sample_picture(300, 5, channels);
            for (std::size_t i = 400; i < 2000; ++i) {
                picture.pixels[i] = 9; // something for the run lengths
            }
            expect_flipped(read(tga_file(picture, run_length_encoded, false)), picture);
        }
    }
}

TEST(ReadImage, BelievesTheHeaderOfATgaWhichWayIsUp)
{
    const Picture picture = sample_picture(9, 4, 3);
    expect_flipped(read(tga_file(picture, false, true)), picture);
    expect_flipped(read(tga_file(picture, true, true)), picture);
}

TEST(ReadImage, ReadsJpegToWithinItsLoss)
{
    Picture picture{32, 16, 3, {}};
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            picture.pixels.insert(picture.pixels.end(), {std::uint8_t(x * 6), std::uint8_t(y * 12), 90});
        }
    }
    const Image image = read(jpeg_file(picture, 95));
    ASSERT_EQ(image.channels, 3);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                ASSERT_NEAR(pixel_from_top(image, x, y)[channel], picture.pixels[(y * 32 + x) * 3 + channel],
                            12);
            }
        }
    }
}

TEST(ReadImage, ReadsAProgressiveJpeg)
{
    EXPECT_EQ(read(progressive_jpeg()).pixels, read(baseline_jpeg()).pixels);
}

TEST(ReadImage, ReadsAJpegWhoseCommentLooksLikeABrokenTable)
{
    Bytes jpeg = baseline_jpeg();
    const Bytes comment = {0xFF, 0xFE, 0,    22,   0xFF, 0xC4, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,
                           0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xDA, 0xFF, 0xFF, 0xFF, 0xFF};
    jpeg.insert(jpeg.begin() + 2, comment.begin(), comment.end());
    EXPECT_EQ(read(jpeg).pixels, read(baseline_jpeg()).pixels);
}

TEST(ReadImage, DecodesAJpegToTheSamePixelsEverywhere)
{
    // The sum that stb_image's portable decoder gives, natively and in wasm; its SSE2 decoder gives another.
    const Image image = read(jpeg_file(sample_picture(61, 47, 3), 60));
    std::uint32_t hash = 2166136261; // FNV-1a
    for (const std::uint8_t byte : image.pixels) {
        hash = (hash ^ byte) * 16777619;
    }
    EXPECT_EQ(hash, 3122848836U);
}

TEST(ReadImage, TellsTheFormatFromTheBytesNotTheName)
{
    const base::Result<Image> image = image::read_image("texture.tga", png_file(sample_picture(2, 2, 3)));
    ASSERT_TRUE(image);
    EXPECT_EQ(image.value().width, 2);
}

TEST(ReadImage, ExpandsGreyToThreeChannels)
{
    const Image image = read(raw_png(2, 1, 8, 0, {{10, 200}}));
    EXPECT_EQ(image.channels, 3);
    EXPECT_EQ(image.pixels, (Bytes{10, 10, 10, 200, 200, 200}));
}

TEST(ReadImage, ExpandsGreyWithAlphaToFourChannels)
{
    const Image image = read(raw_png(2, 1, 8, 4, {{10, 255, 200, 7}}));
    EXPECT_EQ(image.channels, 4);
    EXPECT_EQ(image.pixels, (Bytes{10, 10, 10, 255, 200, 200, 200, 7}));
}

TEST(ReadImage, ExpandsGreyJpegToThreeChannels)
{
    Picture grey{8, 8, 1, Bytes(64, 77)};
    const Image image = read(jpeg_file(grey, 90));
    EXPECT_EQ(image.channels, 3);
    EXPECT_NEAR(image.pixels[0], 77, 2);
}

TEST(ReadImage, ReadsGreyOfFewerThanEightBits)
{
    EXPECT_EQ(read(raw_png(3, 1, 1, 0, {{0b01000000}})).pixels, (Bytes{0, 0, 0, 255, 255, 255, 0, 0, 0}));
    EXPECT_EQ(read(raw_png(2, 1, 4, 0, {{0x0F}})).pixels, (Bytes{0, 0, 0, 255, 255, 255}));
}

TEST(ReadImage, CutsSixteenBitsToTheUpperEight)
{
    EXPECT_EQ(read(raw_png(1, 1, 16, 2, {{0x12, 0x34, 0xAB, 0xFF, 0x00, 0x99}})).pixels,
              (Bytes{0x12, 0xAB, 0x00}));
    EXPECT_EQ(read(raw_png(1, 1, 16, 4, {{0x12, 0x34, 0x80, 0x00}})).pixels, (Bytes{0x12, 0x12, 0x12, 0x80}));
}

TEST(ReadImage, LooksUpAPalette)
{
    const Bytes palette = png_chunk("PLTE", {1, 2, 3, 40, 50, 60});
    EXPECT_EQ(read(raw_png(3, 1, 8, 3, {{1, 0, 1}}, palette)).pixels,
              (Bytes{40, 50, 60, 1, 2, 3, 40, 50, 60}));
    EXPECT_EQ(read(raw_png(3, 1, 1, 3, {{0b10100000}}, palette)).pixels,
              (Bytes{40, 50, 60, 1, 2, 3, 40, 50, 60}));
}

TEST(ReadImage, TakesColoursBehindTheEndOfAPaletteForBlack)
{
    const Bytes palette = png_chunk("PLTE", {1, 2, 3});
    EXPECT_EQ(read(raw_png(3, 1, 8, 3, {{0, 1, 255}}, palette)).pixels, (Bytes{1, 2, 3, 0, 0, 0, 0, 0, 0}));
}

TEST(ReadImage, ReadsTheTransparencyOfAPalette)
{
    Bytes chunks = png_chunk("PLTE", {1, 2, 3, 40, 50, 60});
    const Bytes transparency = png_chunk("tRNS", {128});
    chunks.insert(chunks.end(), transparency.begin(), transparency.end());
    EXPECT_EQ(read(raw_png(2, 1, 8, 3, {{0, 1}}, chunks)).pixels, (Bytes{1, 2, 3, 128, 40, 50, 60, 255}));
}

TEST(ReadImage, MakesATransparentColourAnAlphaChannel)
{
    const Bytes grey = png_chunk("tRNS", {0, 10});
    EXPECT_EQ(read(raw_png(2, 1, 8, 0, {{10, 11}}, grey)).pixels, (Bytes{10, 10, 10, 0, 11, 11, 11, 255}));
    const Bytes colour = png_chunk("tRNS", {0, 1, 0, 2, 0, 3});
    EXPECT_EQ(read(raw_png(2, 1, 8, 2, {{1, 2, 3, 4, 5, 6}}, colour)).pixels,
              (Bytes{1, 2, 3, 0, 4, 5, 6, 255}));
}

TEST(ReadImage, ReadsATgaWithAPalette)
{
    const Bytes tga = {0, 1, 1, 0, 0, 2, 0, 24, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0, 3, 2, 1, 60, 50, 40, 1, 0};
    EXPECT_EQ(read(tga).pixels, (Bytes{40, 50, 60, 1, 2, 3}));
}

TEST(ReadImage, ReadsATgaOfFifteenBitsAndOfGrey)
{
    const Bytes white_and_red = {0, 0, 2, 0, 0, 0,  0, 0,    0,    0,    0,
                                 0, 2, 0, 1, 0, 16, 0, 0xFF, 0x7F, 0x00, 0x7C};
    EXPECT_EQ(read(white_and_red).pixels, (Bytes{255, 255, 255, 255, 0, 0}));
    const Bytes grey = {0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0, 5, 6};
    EXPECT_EQ(read(grey).pixels, (Bytes{5, 5, 5, 6, 6, 6}));
}

TEST(ReadImage, ReadsOnePixelOfEachFormat)
{
    EXPECT_EQ(read(png_file(sample_picture(1, 1, 3))).pixels.size(), 3U);
    EXPECT_EQ(read(jpeg_file(sample_picture(1, 1, 3), 90)).pixels.size(), 3U);
    EXPECT_EQ(read(tga_file(sample_picture(1, 1, 4), true, true)).pixels.size(), 4U);
}

// What is refused.

/// A JPEG whose only scan holds one of its three components.
Bytes jpeg_without_colour()
{
    Bytes jpeg = jpeg_file(sample_picture(64, 64, 3), 90);
    for (std::size_t i = 0; i + 4 < jpeg.size(); ++i) {
        if (jpeg[i] == 0xFF && jpeg[i + 1] == 0xDA) {
            jpeg.resize(i);
            break;
        }
    }
    jpeg.insert(jpeg.end(), {0xFF, 0xDA, 0, 8, 1, 1, 0x00, 0, 63, 0});
    jpeg.resize(jpeg.size() + 4000, 0x2A);
    jpeg.insert(jpeg.end(), {0xFF, 0xD9});
    return jpeg;
}

/// A PNG of 9 x 5 pixels whose compressed data copies bytes from a distance of none (found by fuzzing).
Bytes png_that_copies_from_nowhere()
{
    return {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
            0x00, 0x00, 0x00, 0x09, 0x00, 0x00, 0x00, 0x05, 0x08, 0x06, 0x00, 0x00, 0x01, 0x97, 0x53, 0xc6,
            0x6b, 0x00, 0x00, 0x00, 0x23, 0x49, 0x44, 0x41, 0x54, 0x78, 0x5e, 0x63, 0x64, 0x08, 0x7c, 0x3a,
            0x02, 0xff, 0x00, 0x01, 0x01, 0x00, 0x02, 0xa0, 0x1a, 0x79, 0x7c, 0xea, 0x60, 0x8a, 0xd8, 0x49,
            0x54, 0x84, 0x69, 0x28, 0x51, 0x42, 0x00, 0x00, 0x00, 0x65, 0x08, 0x84, 0xdc, 0xe9, 0x1a, 0xdc,
            0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
}

/// Leaves freed memory of many sizes full of `byte`.
void dirty_memory(std::uint8_t byte)
{
    std::vector<Bytes> blocks;
    for (std::size_t size = 16; size < 200'000; size += size / 4) {
        for (int i = 0; i < 20; ++i) {
            blocks.emplace_back(size, byte);
        }
    }
}

TEST(ReadImage, DoesNotShowWhatWasInMemoryWhereADamagedImageLeavesAHole)
{
    const Bytes images[] = {jpeg_without_colour(), png_that_copies_from_nowhere()};
    for (const Bytes& damaged : images) {
        dirty_memory(0x11);
        const base::Result<Image> first = image::read_image("a", damaged);
        dirty_memory(0xEE);
        const base::Result<Image> second = image::read_image("a", damaged);
        ASSERT_EQ(bool(first), bool(second)) << (first ? second : first).error().message();
        if (first) { // stb_image 2.30 refuses the PNG.
            EXPECT_EQ(first.value().pixels, second.value().pixels);
        } else {
            EXPECT_EQ(&damaged, &images[1]) << first.error().message();
        }
    }
}

} // namespace
