#pragma once

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace image {

/// A picture as glTexImage2D takes it with GL_UNSIGNED_BYTE and GL_UNPACK_ALIGNMENT 1.
struct Image
{
    int width = 0;
    int height = 0;
    int channels = 0; ///< 3: red, green, blue; 4: and alpha, not premultiplied
    std::vector<std::uint8_t>
        pixels; ///< width * height * channels bytes; rows from the bottom up, tightly packed
};

/// The largest width and the largest height that are read, in pixels.
inline constexpr int MAX_IMAGE_SIDE = 16384;

/// The most pixels that are read: 8192 x 4096.
inline constexpr long long MAX_IMAGE_PIXELS = 1LL << 25;

/// The largest file that is read, in bytes.
inline constexpr std::size_t MAX_IMAGE_FILE_BYTES = std::size_t{128} << 20;

/// Reads a PNG, JPEG or TGA image; which one it is is told from the bytes, not from `file_name`.
/// Grey becomes three equal channels, grey with alpha four; palettes are looked up; 16 bits are cut to the
/// upper 8. The pixels are the same natively and on the web. Colour profiles, gamma, Exif orientation and the
/// checksums of PNG are ignored. Which way up a TGA is, is believed of its header. Errors (for the whole
/// file): empty, none of the three, damaged or cut short, a kind not supported, too large. All sizes are
/// checked before memory is asked for.
base::Result<Image> read_image(std::string_view file_name, std::span<const std::uint8_t> bytes);

} // namespace image
