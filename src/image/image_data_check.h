#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace image {

enum class ImageFormat
{
    png,
    jpeg,
    tga_or_unknown, ///< TGA has no signature
};

/// Tells the format from the first bytes, as stb_image does.
ImageFormat image_format(std::span<const std::uint8_t> bytes);

/// Finds out what stb_image would not, to its harm, when it reads the header: see check_jpeg_tables.
/// Returns what is wrong, if anything.
std::string check_image_before_header(ImageFormat format, std::span<const std::uint8_t> bytes);

/// Finds out what stb_image would not, to its or our harm, when it decodes the pixels: see check_jpeg_scans;
/// and a TGA that is cut short, which it fills up with whatever was in memory. Precondition: stb_image found
/// a readable header of `format`, giving `pixels` pixels. Returns what is wrong, if anything.
std::string check_image_data(ImageFormat format, std::span<const std::uint8_t> bytes, long long pixels);

} // namespace image
