#pragma once

#include "legacygl/pixel/pixel_format.h"
#include "legacygl/state/pixel_store.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// Returns how many bytes from its pointer on a client image takes (OpenGL 1.5, 3.6.4); 0 for an empty one or
/// one whose format and type do not fit.
std::size_t client_image_bytes(const PixelStore& store, int width, int height, GLenum format, GLenum type);

/// Converts a client image into RGBA bytes, the bottom row first: luminance spread over the colours, absent
/// colours 0 and absent alpha 255. format and type have no error, pixels holds client_image_bytes().
std::vector<std::uint8_t> unpack_pixels(const PixelStore& store, int width, int height, GLenum format,
                                        GLenum type, const std::uint8_t* pixels);

/// How pixels become luminance where the client asks for it.
enum class ToLuminance : bool
{
    sum, ///< Red, green and blue, as glReadPixels does (OpenGL 1.5, 4.3.2).
    red  ///< As glGetTexImage does (OpenGL 1.5, 6.1.4).
};

/// Writes RGBA bytes into client memory. format and type have no error.
void pack_pixels(const PixelStore& store, int width, int height, GLenum format, GLenum type,
                 std::span<const std::uint8_t> rgba, ToLuminance luminance, std::uint8_t* out);

/// Writes depths, in steps of 1 / (2^24 - 1), into client memory. type has one value and no error.
void pack_depths(const PixelStore& store, int width, int height, GLenum type,
                 std::span<const std::uint32_t> depths, std::uint8_t* out);

/// Writes stencil values into client memory. type has one value and no error, or is GL_BITMAP, which gets the
/// lowest bit of each.
void pack_stencils(const PixelStore& store, int width, int height, GLenum type,
                   std::span<const std::uint8_t> values, std::uint8_t* out);

} // namespace legacygl
