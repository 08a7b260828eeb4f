#include "image/png_palette.h"

#include <cstddef>
#include <string_view>

namespace image {
namespace {

// PNG specification (ISO/IEC 15948), 5.3: a chunk is a length, a type, so many bytes of data and a checksum.
constexpr std::size_t SIGNATURE_SIZE = 8;
constexpr std::size_t LENGTH_SIZE = 4;
constexpr std::size_t TYPE_SIZE = 4;
constexpr std::size_t CHECKSUM_SIZE = 4;
constexpr std::size_t FULL_PALETTE = std::size_t{256} * 3;

std::size_t big_endian(std::span<const std::uint8_t> four)
{
    return std::size_t{four[0]} << 24 | std::size_t{four[1]} << 16 | std::size_t{four[2]} << 8 | four[3];
}

bool has_type(std::span<const std::uint8_t> chunk, std::string_view type)
{
    for (std::size_t i = 0; i < TYPE_SIZE; ++i) {
        if (chunk[LENGTH_SIZE + i] != static_cast<std::uint8_t>(type[i])) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<std::uint8_t> png_with_full_palette(std::span<const std::uint8_t> bytes)
{
    constexpr std::size_t HEADER_SIZE = LENGTH_SIZE + TYPE_SIZE;
    for (std::size_t at = SIGNATURE_SIZE; bytes.size() >= at + HEADER_SIZE;) {
        const std::span<const std::uint8_t> chunk = bytes.subspan(at);
        const std::size_t length = big_endian(chunk);
        if (length > chunk.size() - HEADER_SIZE || has_type(chunk, "IDAT")) {
            return {};
        }
        if (has_type(chunk, "PLTE")) {
            if (length >= FULL_PALETTE || length % 3 != 0) {
                return {};
            }
            std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
            copy[at + 2] = FULL_PALETTE >> 8;
            copy[at + 3] = FULL_PALETTE & 255;
            copy.insert(copy.begin() + static_cast<std::ptrdiff_t>(at + HEADER_SIZE + length),
                        FULL_PALETTE - length, 0);
            return copy;
        }
        at += HEADER_SIZE + length + CHECKSUM_SIZE;
    }
    return {};
}

} // namespace image
