#include "image/png_palette.h"

#include <cstddef>
#include <string_view>

namespace image {
namespace {

// PNG specification (ISO/IEC 15948), 5.3: a chunk is a length, a type, so many bytes of data and a checksum.
constexpr std::size_t signature_size = 8;
constexpr std::size_t length_size = 4;
constexpr std::size_t type_size = 4;
constexpr std::size_t checksum_size = 4;
constexpr std::size_t full_palette = std::size_t{256} * 3;

std::size_t big_endian(std::span<const std::uint8_t> four)
{
    return std::size_t{four[0]} << 24 | std::size_t{four[1]} << 16 | std::size_t{four[2]} << 8 | four[3];
}

bool has_type(std::span<const std::uint8_t> chunk, std::string_view type)
{
    for (std::size_t i = 0; i < type_size; ++i) {
        if (chunk[length_size + i] != static_cast<std::uint8_t>(type[i])) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<std::uint8_t> png_with_full_palette(std::span<const std::uint8_t> bytes)
{
    constexpr std::size_t header_size = length_size + type_size;
    for (std::size_t at = signature_size; bytes.size() >= at + header_size;) {
        const std::span<const std::uint8_t> chunk = bytes.subspan(at);
        const std::size_t length = big_endian(chunk);
        if (length > chunk.size() - header_size || has_type(chunk, "IDAT")) {
            return {};
        }
        if (has_type(chunk, "PLTE")) {
            if (length >= full_palette || length % 3 != 0) {
                return {};
            }
            std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
            copy[at + 2] = full_palette >> 8;
            copy[at + 3] = full_palette & 255;
            copy.insert(copy.begin() + static_cast<std::ptrdiff_t>(at + header_size + length),
                        full_palette - length, 0);
            return copy;
        }
        at += header_size + length + checksum_size;
    }
    return {};
}

} // namespace image
