#pragma once

#include "checks/frame_capture.h"

#include <cstdint>
#include <vector>

namespace checks {

/// Draws a frame and reads what the subject's target shows: 4 bytes a pixel, rows bottom first.
std::vector<std::uint8_t> picture_of(const CheckSubject& subject, const app::Frame& frame);

/// Returns the share, 0 to 1, of pixels whose red, green or blue differ. Precondition: of one size.
double share_of_other_pixels(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other);

} // namespace checks
