#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mesh {

enum class ImageFormat
{
    png,
    jpeg,
    tga_or_unknown, ///< TGA has no signature
};

/// Tells the format from the first bytes.
ImageFormat image_format(std::span<const std::uint8_t> bytes);

/// Finds out whether the pixels that the header promises can be in `bytes` at all, where stb_image would not
/// notice: it fills up a TGA that is cut short with whatever was in memory, and works for minutes on a JPEG
/// of a few bytes that claims to be huge, or to have thousands of scans. Precondition: stb_image found a
/// readable header of `format`, giving `pixels` pixels. Returns what is wrong, if anything.
std::string check_image_data(ImageFormat format, std::span<const std::uint8_t> bytes, long long pixels);

} // namespace mesh
