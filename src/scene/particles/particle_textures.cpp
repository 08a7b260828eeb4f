#include "scene/particles/particle_textures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace scene {
namespace {

constexpr int SIDE = 64; // pixels

/// Makes an image whose alpha is a function of the place in it, -1 to 1 each way.
template <class Alpha> image::Image image_of(const Alpha& alpha)
{
    image::Image image{.width = SIDE, .height = SIDE, .channels = 4, .pixels = {}};
    for (int row = 0; row < SIDE; ++row) {
        for (int column = 0; column < SIDE; ++column) {
            const double opacity = alpha((2.0 * column + 1.0) / SIDE - 1.0, (2.0 * row + 1.0) / SIDE - 1.0);
            image.pixels.insert(
                image.pixels.end(),
                {255, 255, 255,
                 static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)))});
        }
    }
    return image;
}

/// Falls from 1 in the middle to 0 at the rim, smoothly at both.
double falloff(double squared_distance)
{
    const double rest = std::max(0.0, 1.0 - squared_distance);
    return rest * rest;
}

} // namespace

image::Image soft_dot_image()
{
    return image_of([](double x, double y) { return falloff(x * x + y * y); });
}

image::Image streak_image()
{
    // Brightest a little behind its head, from where it fades towards the tail.
    constexpr double BRIGHTEST_AT = 0.6;
    return image_of([](double x, double y) {
        const double along = y > BRIGHTEST_AT ? (y - BRIGHTEST_AT) / (1.0 - BRIGHTEST_AT)
                                              : (BRIGHTEST_AT - y) / (1.0 + BRIGHTEST_AT);
        return falloff(x * x) * falloff(along * along);
    });
}

} // namespace scene
