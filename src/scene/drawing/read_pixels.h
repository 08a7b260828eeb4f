#pragma once

#include <cstdint>
#include <vector>

namespace scene {

/// Returns the current picture: 4 bytes a pixel (red, green, blue, alpha), rows bottom first.
/// width, height: pixels from the lower left corner, both at least 1. Waits until all is drawn.
std::vector<std::uint8_t> read_pixels(int width, int height);

} // namespace scene
