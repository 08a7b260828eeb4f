#pragma once

#include "mesh/image.h"

namespace scene {

/// Returns a white dot that fades towards its rim, in its alpha; nothing at the rim itself.
mesh::Image soft_dot_image();

/// Returns a white streak that fades towards its sides and its tail, in its alpha; its head is at the image's
/// last row, which is the greater second texture coordinate.
mesh::Image streak_image();

} // namespace scene
