#include "legacygl/pixel/texture_image.h"

#include "legacygl/pixel/pixel_format.h"
#include "legacygl/state/internal_format.h"

#include <algorithm>

namespace legacygl {
namespace {

/// Returns a byte as it comes back from that many bits; all of it for 0 bits, which the format drops anyway.
std::uint8_t through_bits(std::uint8_t value, int bits)
{
    if (bits == 0 || bits == 8) {
        return value;
    }
    const int greatest = (1 << bits) - 1;
    const int kept = (value * greatest + 127) / 255;
    return byte_of_bits(static_cast<std::uint32_t>(kept), bits);
}

std::uint8_t* texel(TextureImage& image, int x, int y)
{
    return image.rgba.data() + (static_cast<std::size_t>(y) * image.width + x) * 4;
}

void store(TextureImage& image, const TexelRectangle& part, std::span<const std::uint8_t> rgba)
{
    const BaseFormat base = base_format(image.internal_format);
    const std::array<int, 4> bits = texel_bits(image.internal_format);
    const std::uint8_t* from = rgba.data();
    for (int y = 0; y < part.height; ++y) {
        std::uint8_t* to = texel(image, part.x, part.y + y);
        for (int i = 0; i < part.width; ++i, from += 4, to += 4) {
            for (int c = 0; c < 4; ++c) {
                to[c] = through_bits(from[c], bits[c]);
            }
            keep_components<std::uint8_t>(base, to, 255);
        }
    }
    image.changed = true;
}

/// Recreates the levels below the base one; their texels are derived when they are needed.
void derive_levels(Texture& texture)
{
    const int base = texture.parameters.sampling.base_level;
    const TextureImage from = {texture.levels[base].internal_format, texture.levels[base].width,
                               texture.levels[base].height};
    const int last =
        std::min(base + level_count(from.width, from.height) - 1, texture.parameters.sampling.max_level);
    if (static_cast<int>(texture.levels.size()) <= last) {
        texture.levels.resize(last + 1);
    }
    for (int level = base + 1; level <= last; ++level) {
        TextureImage& image = texture.levels[level];
        image = {from.internal_format, std::max(1, from.width >> (level - base)),
                 std::max(1, from.height >> (level - base))};
        image.derived = true;
    }
    texture.levels_to_derive = true;
}

bool derives(const Texture& texture, int level)
{
    return texture.parameters.generate_mipmap && level == texture.parameters.sampling.base_level &&
           texture.levels[level].width > 0 && texture.levels[level].height > 0;
}

/// Where a texel of a derived level is sampled in the level above, along one axis: between two texels.
struct Between
{
    int first, second; ///< Texels of the level above.
    int part;          ///< Of the second one, in 256ths.
};

Between between(int texel, int size, int size_above)
{
    // The texel's centre in 256ths of a texel of the level above, from its first texel's centre on.
    const std::int64_t centre_twice = (2 * std::int64_t{texel} + 1) * size_above * 256;
    const int place = static_cast<int>((centre_twice + size) / (2 * size)) - 128;
    const int first = std::clamp(place >> 8, 0, size_above - 1);
    return {first, std::min(first + 1, size_above - 1), place & 255};
}

/// Returns the texels of a derived level: the level above, sampled with GL_LINEAR at their centres by eight
/// bits, rounded along each axis, as Mesa's llvmpipe does.
std::vector<std::uint8_t> reduce(const std::vector<std::uint8_t>& above, int width, int height)
{
    const int half_width = std::max(1, width / 2), half_height = std::max(1, height / 2);
    std::vector<std::uint8_t> to;
    to.reserve(static_cast<std::size_t>(half_width) * half_height * 4);
    const auto mixed = [](int a, int b, int part) { return a + (((b - a) * part + 128) >> 8); };
    for (int y = 0; y < half_height; ++y) {
        const Between rows = between(y, half_height, height);
        for (int x = 0; x < half_width; ++x) {
            const Between columns = between(x, half_width, width);
            for (int c = 0; c < 4; ++c) {
                const auto along = [&](int row) {
                    const auto at = [&](int column) {
                        return above[(static_cast<std::size_t>(row) * width + column) * 4 + c];
                    };
                    return mixed(at(columns.first), at(columns.second), columns.part);
                };
                to.push_back(
                    static_cast<std::uint8_t>(mixed(along(rows.first), along(rows.second), rows.part)));
            }
        }
    }
    return to;
}

std::vector<std::uint8_t> sampled_texels(const Texture& texture, int level)
{
    const TextureImage& image = texture.levels[level];
    if (!image.derived) {
        return image.rgba;
    }
    const TextureImage& above = texture.levels[level - 1];
    return reduce(sampled_texels(texture, level - 1), above.width, above.height);
}

} // namespace

int level_count(int width, int height)
{
    int count = 1;
    for (int size = std::max(width, height); size > 1; size /= 2) {
        ++count;
    }
    return count;
}

void set_level(Texture& texture, int level, GLint internal_format, int width, int height,
               std::span<const std::uint8_t> rgba)
{
    if (texture.levels.size() <= static_cast<std::size_t>(level)) {
        texture.levels.resize(level + 1);
    }
    TextureImage& image = texture.levels[level];
    image = {internal_format, width, height};
    image.rgba.resize(static_cast<std::size_t>(width) * height * 4);
    if (!rgba.empty()) {
        store(image, {0, 0, width, height}, rgba);
    }
    image.changed = true;
    if (derives(texture, level)) {
        derive_levels(texture);
    }
}

void set_part(Texture& texture, int level, const TexelRectangle& part, std::span<const std::uint8_t> rgba)
{
    if (part.width == 0 || part.height == 0) {
        return;
    }
    TextureImage& image = texture.levels[level];
    if (image.derived) {
        image.rgba = sampled_texels(texture, level);
        image.derived = false;
    }
    store(image, part, rgba);
    if (derives(texture, level)) {
        derive_levels(texture);
    }
}

std::vector<std::uint8_t> level_texels(const Texture& texture, int level)
{
    std::vector<std::uint8_t> rgba = sampled_texels(texture, level);
    const BaseFormat base = base_format(texture.levels[level].internal_format);
    const bool red_only =
        base == BaseFormat::luminance || base == BaseFormat::luminance_alpha || base == BaseFormat::intensity;
    for (std::size_t i = 0; red_only && i < rgba.size(); i += 4) {
        rgba[i + 1] = rgba[i + 2] = 0;
        if (base == BaseFormat::intensity) {
            rgba[i + 3] = 255;
        }
    }
    return rgba;
}

} // namespace legacygl
