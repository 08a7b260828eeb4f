#include "legacygl/state/texturing.h"

#include <algorithm>

namespace legacygl {

bool Texture::complete() const
{
    if (levels.empty() || levels[0].width == 0 || levels[0].height == 0)
        return false;
    const bool mipmapped = sampling.minify != GL_NEAREST && sampling.minify != GL_LINEAR;
    if (!mipmapped || generate_mipmap)
        return true;
    int width = levels[0].width, height = levels[0].height;
    for (std::size_t level = 1; width > 1 || height > 1; ++level) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        if (level >= levels.size() || levels[level].width != width || levels[level].height != height ||
            levels[level].internal_format != levels[0].internal_format)
            return false;
    }
    return true;
}

} // namespace legacygl
