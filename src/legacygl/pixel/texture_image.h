#pragma once

#include "legacygl/state/texturing.h"

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>

namespace legacygl {

/// A rectangle of texels of one level.
struct TexelRectangle
{
    int x, y, width, height;
};

/// Returns the number of levels a texture of the size has, down to 1 × 1.
int level_count(int width, int height);

/// Makes a level of that size; rgba: its pixels, or empty for zeros. Derives the smaller levels where the
/// texture asks for that. The texture's levels grow as needed.
void set_level(Texture& texture, int level, GLint internal_format, int width, int height,
               std::span<const std::uint8_t> rgba);

/// Replaces a part of a level that contains it.
void set_part(Texture& texture, int level, const TexelRectangle& part, std::span<const std::uint8_t> rgba);

/// Returns a level's RGBA texels as glGetTexImage gives them: luminance and intensity in red alone, absent
/// colours 0, absent alpha 255 (OpenGL 1.5, table 6.1). The level exists.
std::vector<std::uint8_t> level_texels(const Texture& texture, int level);

} // namespace legacygl
