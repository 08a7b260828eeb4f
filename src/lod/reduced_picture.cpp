#include "lod/reduced_picture.h"

#include <cstddef>

namespace lod {

namespace {

constexpr std::size_t CHANNELS = 4;

} // namespace

ReducedPicture reduced(const Picture& picture, int side)
{
    ReducedPicture result{.width = picture.width / side, .height = picture.height / side, .rgba = {}};
    const auto row = static_cast<std::size_t>(picture.width) * CHANNELS;
    const auto patch = static_cast<std::size_t>(side);
    const std::size_t area = patch * patch;
    for (std::size_t y = 0; y < static_cast<std::size_t>(result.height); ++y) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(result.width); ++x) {
            const std::size_t corner = y * patch * row + x * patch * CHANNELS;
            for (std::size_t channel = 0; channel < CHANNELS; ++channel) {
                std::size_t sum = 0;
                for (std::size_t pixel = 0; pixel < area; ++pixel) {
                    sum += picture.rgba[corner + pixel / patch * row + pixel % patch * CHANNELS + channel];
                }
                result.rgba.push_back(static_cast<std::uint8_t>((sum + area / 2) / area));
            }
        }
    }
    return result;
}

} // namespace lod
