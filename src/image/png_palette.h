#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace image {

/// Returns a copy of a PNG whose palette is filled up to 256 colours with black, for stb_image, which does
/// not check whether a pixel's colour is in the palette and would show what was on the stack. Empty: there is
/// no palette, or it is full, or not one. The checksum, which stb_image ignores, is not recomputed.
/// Precondition: the bytes start with PNG's signature.
std::vector<std::uint8_t> png_with_full_palette(std::span<const std::uint8_t> bytes);

} // namespace image
