#include "legacygl/draw/target_copy.h"

namespace legacygl {

TextureId TargetCopy::read(Backend& backend, bool front, const PixelBox& box)
{
    if (!texture_.valid()) {
        texture_.set(backend, backend.create_texture());
        Sampling nearest;
        nearest.minify = nearest.magnify = GL_NEAREST;
        backend.sampling(texture_.id(), nearest);
    }
    const int width = box.x1 - box.x0, height = box.y1 - box.y0;
    pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    backend.read_pixels(front, box.x0, box.y0, width, height, pixels_);
    backend.texture_image(texture_.id(), 0, width, height, pixels_);
    return texture_.id();
}

} // namespace legacygl
