#pragma once

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>

namespace legacygl {

/// The base formats of OpenGL 1.5, table 3.15.
enum class BaseFormat : std::uint8_t
{
    none,
    alpha,
    luminance,
    luminance_alpha,
    intensity,
    rgb,
    rgba
};

/// Returns the base format of an internal format, or none when it is not one (OpenGL 1.5, table 3.15, 3.16).
BaseFormat base_format(GLint internal_format);

/// Returns how many bits a texel of the internal format keeps of red, green, blue and alpha; luminance and
/// intensity count as red. At most 8, even where the format asks for more. Preconditions: it has a base
/// format.
std::array<int, 4> texel_bits(GLint internal_format);

/// Keeps what the base format keeps of a pixel, spread as the sampler returns it (OpenGL 1.5, table 3.15).
template <class T> void keep_components(BaseFormat base, T* p, T one)
{
    switch (base) {
    case BaseFormat::alpha:
        p[0] = p[1] = p[2] = T{0};
        break;
    case BaseFormat::luminance:
        p[1] = p[2] = p[0];
        p[3] = one;
        break;
    case BaseFormat::luminance_alpha:
        p[1] = p[2] = p[0];
        break;
    case BaseFormat::intensity:
        p[1] = p[2] = p[3] = p[0];
        break;
    case BaseFormat::rgb:
        p[3] = one;
        break;
    default:
        break;
    }
}

/// Returns a colour as a texture of the base format would sample it (OpenGL 1.5, table 3.15).
glm::vec4 as_sampled(BaseFormat base, const glm::vec4& color);

} // namespace legacygl
