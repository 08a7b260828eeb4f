#pragma once

#include "image/image.h"

#include <cstdint>
#include <span>

namespace assets {

/// Tells whether an image file is of the form that the lab's texture.tga has: a run-length encoded TGA of
/// 1024 x 1024 pixels of 24 bits whose header says that its rows begin at the bottom. The lab's begin at the
/// top. Nothing else tells the two apart, so this alone is no reason to turn a picture round: the meshes have
/// to be the lab's, too.
bool has_form_of_original_texture(std::span<const std::uint8_t> bytes);

/// Puts the rows of an image in the other order.
void turn_upside_down(image::Image& image);

} // namespace assets
