#pragma once

#include "legacygl/glu/client_image.h"

namespace legacygl::glu {

/// Reads a client image as 16-bit values, fractions of 65535 (an index stays as it is), as libGLU does.
/// format and type have passed check_format_and_type().
std::vector<GLushort> read_shorts(const PixelStoreModes& modes, int width, int height, GLenum format,
                                  GLenum type, const void* data);

/// Writes such an image into client memory.
void write_shorts(const PixelStoreModes& modes, int width, int height, GLenum format, GLenum type,
                  const std::vector<GLushort>& image, void* data);

/// Scales such an image by a box filter, larger images wrapping around at their sides; all sizes positive.
std::vector<GLushort> scale_shorts(const std::vector<GLushort>& image, int components, int width, int height,
                                   int new_width, int new_height);

} // namespace legacygl::glu
