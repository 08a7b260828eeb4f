#include "scene/drawing/texture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <GL/gl.h>

namespace scene {
namespace {

/// Returns the image with 4 bytes a pixel: its rows then meet OpenGL's default alignment at any width.
std::vector<std::uint8_t> as_rgba(const image::Image& image)
{
    const auto pixel_count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> rgba(pixel_count * 4, 255);
    for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
        for (std::size_t channel = 0; channel < channels; ++channel) {
            rgba[pixel * 4 + channel] = image.pixels[pixel * channels + channel];
        }
    }
    return rgba;
}

} // namespace

unsigned upload_texture(const image::Image& image)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE); // OpenGL 1.4; must precede the image
    const std::vector<std::uint8_t> rgba = as_rgba(image);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
    return name;
}

} // namespace scene
