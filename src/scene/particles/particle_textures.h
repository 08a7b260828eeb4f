#pragma once

#include "image/image.h"

namespace scene {

/// Returns a white dot that fades towards its rim, in its alpha; nothing at the rim itself.
image::Image soft_dot_image();

/// Returns a white streak that fades towards its sides and its tail, in its alpha; its head is at the image's
/// last row, which is the greater second texture coordinate.
image::Image streak_image();

} // namespace scene
