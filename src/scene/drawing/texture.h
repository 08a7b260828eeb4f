#pragma once

#include "image/image.h"

namespace scene {

/// Uploads an image as a repeating 2D texture with mipmaps and returns its name.
/// Call it with a context current; the texture stays bound.
unsigned upload_texture(const image::Image& image);

} // namespace scene
