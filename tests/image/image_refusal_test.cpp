#include "tests/image/read_image.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>

namespace {

using image::Image;

std::string refusal(const Bytes& bytes)
{
    const base::Result<Image> result = image::read_image("test.png", bytes);
    if (result) {
        return "was read";
    }
    EXPECT_EQ(broken_invariant(result.error(), 0), "");
    return result.error().message();
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

Bytes cut_short(Bytes bytes, std::size_t size)
{
    bytes.resize(size);
    return bytes;
}

TEST(ReadImageRefuses, AnEmptyFile)
{
    EXPECT_EQ(refusal({}), "test.png: the file is empty");
}

TEST(ReadImageRefuses, WhatIsNoImage)
{
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(refusal(Bytes(text.begin(), text.end())),
              "test.png: the file is not a PNG, JPEG or TGA image; save it as one of these");
    EXPECT_TRUE(contains(refusal({0}), "is not a PNG, JPEG or TGA image"));
    EXPECT_TRUE(
        contains(refusal({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0, 0, 0, 0}), "is not a PNG, JPEG or TGA"));
    EXPECT_TRUE(
        contains(refusal({'B', 'M', 30, 0, 0, 0, 0, 0, 0, 0, 26, 0, 0, 0}), "is not a PNG, JPEG or TGA"));
}

TEST(ReadImageRefuses, EveryFormatCutShortAnywhere)
{
    const Picture picture = sample_picture(40, 30, 3);
    for (const Bytes& file :
         {png_file(picture), jpeg_file(picture, 80), progressive_jpeg(), tga_file(picture, false, false),
          tga_file(picture, true, true), raw_png(40, 1, 8, 0, {Bytes(40, 3)})}) {
        for (std::size_t size = 0; size + 12 < file.size(); ++size) { // PNG's last 12 bytes hold nothing
            ASSERT_NE(refusal(cut_short(file, size)), "was read") << size << " of " << file.size();
        }
    }
}

TEST(ReadImageRefuses, ACutOrDamagedImageWithAnAdvice)
{
    const Bytes png = png_file(sample_picture(40, 30, 3));
    EXPECT_EQ(refusal(cut_short(png, 200)),
              "test.png: the image is damaged or cut short ('outofdata'); copy or save it again");
    const Bytes tga = tga_file(sample_picture(40, 30, 3), true, false);
    EXPECT_EQ(refusal(cut_short(tga, 200)), "test.png: the image is cut short; copy or save it again");
    Bytes unknown_chunk = raw_png(1, 1, 8, 0, {{1}}, png_chunk("ZZZZ", {}));
    EXPECT_TRUE(
        contains(refusal(unknown_chunk), "the image is damaged or cut short ('ZZZZ PNG chunk not known')"));
}

TEST(ReadImageRefuses, AnImageTooLargeOnASide)
{
    EXPECT_EQ(refusal(raw_png(16385, 1, 8, 0, {Bytes(16385, 0)})),
              "test.png: the image is too large: at most 16384 pixels a side and 33554432 in all are read; "
              "scale it down");
    EXPECT_TRUE(contains(refusal(raw_png(1, 16385, 8, 0, {})), "too large"));
    EXPECT_EQ(read(raw_png(16384, 1, 8, 0, {Bytes(16384, 0)})).width, 16384);
}

TEST(ReadImageRefuses, AnImageOfTooManyPixelsBeforeItAsksForMemory)
{
    EXPECT_TRUE(contains(refusal(raw_png(16384, 16384, 16, 6, {})), "too large"));
    Bytes tga = {0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x00, 0x40, 0x00, 0x40, 32, 0, 0};
    EXPECT_TRUE(contains(refusal(tga), "too large"));
}

TEST(ReadImageRefuses, AHugeSizeThatTheFileCannotHold)
{
    const Bytes tga = {0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x00, 0x10, 0x00, 0x10, 32, 0, 0xFF, 1, 2, 3, 4};
    EXPECT_TRUE(contains(refusal(tga), "cut short"));
    Bytes jpeg = jpeg_file(sample_picture(16, 16, 3), 50);
    for (std::size_t i = 0; i + 8 < jpeg.size(); ++i) {
        if (jpeg[i] == 0xFF && jpeg[i + 1] == 0xC0) // the frame header: height and width follow
        {
            jpeg[i + 5] = jpeg[i + 7] = 0x10;
            break;
        }
    }
    EXPECT_TRUE(contains(refusal(jpeg), "cut short"));
}

TEST(ReadImageRefuses, AJpegOfThousandsOfScans)
{
    Bytes jpeg = jpeg_file(sample_picture(1024, 1024, 3), 90);
    for (int i = 0; i < 2000; ++i) {
        jpeg.insert(jpeg.end(), {0xFF, 0xDA});
    }
    EXPECT_TRUE(contains(refusal(jpeg), "has 2001 scans, too many for its size"));
}

/// A segment with one Huffman table of `codes` codes of 16 bits.
Bytes huffman_table(int codes)
{
    const int length = 2 + 17 + codes;
    Bytes segment = {0xFF, 0xC4, std::uint8_t(length >> 8), std::uint8_t(length & 255), 0x00};
    segment.resize(segment.size() + 14); // none of 1 to 14 bits
    segment.push_back(std::uint8_t(codes - std::min(codes, 200)));
    segment.push_back(std::uint8_t(std::min(codes, 200)));
    segment.resize(segment.size() + std::size_t(codes));
    return segment;
}

TEST(ReadImageRefuses, AJpegWithAHuffmanTableThatIsTooLong)
{
    // stb_image 2.27 writes behind the end of its table, wherever in the file this one stands.
    const Bytes table = huffman_table(257);
    for (const std::uint8_t marker :
         {0xDB, 0xC0, 0xDA, 0xD9}) // before the frame, in it, before the scan, behind it
    {
        Bytes jpeg = baseline_jpeg();
        const std::uint8_t wanted[] = {0xFF, marker};
        const auto at = std::search(jpeg.begin(), jpeg.end(), std::begin(wanted), std::end(wanted));
        ASSERT_NE(at, jpeg.end());
        jpeg.insert(at, table.begin(), table.end());
        EXPECT_TRUE(contains(refusal(jpeg), "in a Huffman table")) << int(marker);
        jpeg.insert(jpeg.begin(), 0xFF); // stb_image takes any number of these for the start
        EXPECT_TRUE(contains(refusal(jpeg), "in a Huffman table")) << int(marker);
    }
}

TEST(ReadImage, ReadsAJpegWithAFullHuffmanTable)
{
    Bytes jpeg = baseline_jpeg();
    const Bytes table = huffman_table(256);
    jpeg.insert(jpeg.begin() + 2, table.begin(), table.end()); // one that is replaced later on
    EXPECT_EQ(read(jpeg).pixels, read(baseline_jpeg()).pixels);
}

TEST(ReadImageRefuses, APngThatUnpacksWithoutEnd)
{
    // Deflate's longest copy, 258 bytes in 13 bits, again and again: 34 MB in 200 KB, for a picture of one
    // pixel.
    Bytes zlib = {0x78, 0x01};
    unsigned bits = 0;
    int bit_count = 0;
    const auto append = [&](std::initializer_list<int> ones_and_zeros) {
        for (const int bit : ones_and_zeros) {
            bits |= unsigned(bit) << bit_count;
            if (++bit_count == 8) {
                zlib.push_back(std::uint8_t(bits));
                bits = 0;
                bit_count = 0;
            }
        }
    };
    append({1, 1, 0});                // the last block, with the fixed code
    append({0, 0, 1, 1, 0, 0, 0, 0}); // a zero
    while (zlib.size() < 200'000) {
        append({1, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0}); // 258 bytes like the one before
    }
    append({0, 0, 0, 0, 0, 0, 0}); // the end
    zlib.resize(zlib.size() + 8);
    EXPECT_EQ(
        refusal(raw_png(1, 1, 8, 0, {}, png_chunk("IDAT", zlib))),
        "test.png: the image needs more memory than is allowed for one; scale it down or save it again");
}

TEST(ReadImageRefuses, ATgaStoredFromRightToLeft)
{
    Bytes tga = tga_file(sample_picture(4, 4, 3), false, false);
    tga[17] |= 0x10;
    EXPECT_TRUE(contains(refusal(tga), "stored from right to left"));
}

TEST(ReadImageRefuses, AHugeFile)
{
    EXPECT_TRUE(
        contains(refusal(Bytes(image::MAX_IMAGE_FILE_BYTES + 1)), "128 MB and at most 128 MB are read"));
}

} // namespace
