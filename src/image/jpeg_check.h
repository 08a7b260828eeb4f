#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace image {

/// Finds Huffman tables that stb_image 2.27 would write behind: those with more than 256 codes.
/// To be called before any other look at the file. Returns what is wrong, if anything.
std::string check_jpeg_tables(std::span<const std::uint8_t> bytes);

/// Finds out whether the file is cut short, where stb_image 2.30 shows what there is, and whether
/// decoding would take minutes: a file of a few bytes may claim to have millions of pixels, or thousands of
/// scans over them. `pixels` is what its header gives. Returns what is wrong, if anything.
std::string check_jpeg_scans(std::span<const std::uint8_t> bytes, long long pixels);

} // namespace image
