#include "scene/drawing/read_pixels.h"

#include <cstddef>

#include <GL/gl.h>

namespace scene {

std::vector<std::uint8_t> read_pixels(int width, int height)
{
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

} // namespace scene
