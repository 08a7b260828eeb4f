#include "assets/original_texture.h"

#include <algorithm>
#include <cstddef>

namespace assets {

bool has_form_of_original_texture(std::span<const std::uint8_t> bytes)
{
    // Truevision TGA File Format Specification 2.0, "TGA file header".
    constexpr std::size_t HEADER_SIZE = 18;
    constexpr int RUN_LENGTH_ENCODED_COLOUR = 10;
    constexpr int FROM_THE_TOP = 0x20;
    constexpr int SIDE = 1024;
    if (bytes.size() < HEADER_SIZE) {
        return false;
    }
    const int width = bytes[12] + 256 * bytes[13];
    const int height = bytes[14] + 256 * bytes[15];
    return bytes[1] == 0 && bytes[2] == RUN_LENGTH_ENCODED_COLOUR && width == SIDE && height == SIDE &&
           bytes[16] == 24 && (bytes[17] & FROM_THE_TOP) == 0;
}

void turn_upside_down(image::Image& image)
{
    const auto row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
    auto lower = image.pixels.begin();
    for (int y = 0; y < image.height / 2; ++y, lower += row) {
        std::swap_ranges(lower, lower + row, image.pixels.end() - row * (y + 1));
    }
}

} // namespace assets
