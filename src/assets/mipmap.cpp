#include "assets/mipmap.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>

namespace assets {

namespace {

/// Holds a rectangle of pixels, without its right and its lower edge.
struct Rectangle
{
    int left, top, right, bottom;
};

glm::vec3 mean_of(const image::Image& image, const Rectangle& part)
{
    glm::vec3 sum(0.0f);
    for (int y = part.top; y < part.bottom; ++y) {
        for (int x = part.left; x < part.right; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                      static_cast<std::size_t>(x);
            const std::uint8_t* channels =
                image.pixels.data() + pixel * static_cast<std::size_t>(image.channels);
            sum += glm::vec3(channels[0], channels[1], channels[2]);
        }
    }
    const int count = (part.right - part.left) * (part.bottom - part.top);
    return sum / (255.0f * static_cast<float>(count));
}

} // namespace

Mipmap::Mipmap(const image::Image& image, int side)
    : width_((image.width + side - 1) / side), height_((image.height + side - 1) / side)
{
    for (int y = 0; y < image.height; y += side) {
        for (int x = 0; x < image.width; x += side) {
            pixels_.push_back(
                mean_of(image, {x, y, std::min(x + side, image.width), std::min(y + side, image.height)}));
        }
    }
}

glm::vec3 Mipmap::colour_at(const glm::vec2& place) const
{
    const glm::vec2 at = glm::fract(place) * glm::vec2(width_, height_) - 0.5f;
    const glm::vec2 first = glm::floor(at);
    const glm::vec2 part = at - first;
    const glm::vec3 above = glm::mix(pixel(first.x, first.y), pixel(first.x + 1.0f, first.y), part.x);
    const glm::vec3 below =
        glm::mix(pixel(first.x, first.y + 1.0f), pixel(first.x + 1.0f, first.y + 1.0f), part.x);
    return glm::mix(above, below, part.y);
}

/// Returns a pixel by whole coordinates, from one before the first to one after the last.
const glm::vec3& Mipmap::pixel(float x, float y) const
{
    const auto wrapped = [](float coordinate, int size) {
        return static_cast<std::size_t>((static_cast<int>(coordinate) + size) % size);
    };
    return pixels_[wrapped(y, height_) * static_cast<std::size_t>(width_) + wrapped(x, width_)];
}

} // namespace assets
