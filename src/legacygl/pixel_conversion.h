#pragma once

#include "legacygl/shader_key.h"
#include "legacygl/state/texturing.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace legacygl {

/// Returns the base format of an internal format, or none when it is not one (OpenGL 1.5, table 3.15, 3.16).
BaseFormat base_format(GLint internal_format);

/// Returns how many values a pixel of the format has (OpenGL 1.5, table 3.6); 0: not supported.
int values_per_pixel(GLenum format);

/// Returns the bytes of one value of the type; 0: not supported.
int bytes_per_value(GLenum type);

/// Returns how many bytes from its pointer on a client image takes (OpenGL 1.5, 3.6.4).
std::size_t client_image_bytes(const PixelStore& store, int width, int height, GLenum format, GLenum type);

/// Converts a client image into RGBA bytes as a texture of the base format samples them: the bottom row
/// first, luminance and intensity spread over the colours, absent colours 0 and absent alpha 1.
/// format and type are supported, pixels holds client_image_bytes().
std::vector<std::uint8_t> unpack_texture(const PixelStore& store, int width, int height, GLenum format,
                                         GLenum type, BaseFormat base, const std::uint8_t* pixels);

/// Writes RGBA bytes into client memory of the given format (GL_RGBA, GL_RGB …) and type.
void pack_pixels(const PixelStore& store, int width, int height, GLenum format, GLenum type,
                 const std::uint8_t* rgba, std::uint8_t* out);

} // namespace legacygl
