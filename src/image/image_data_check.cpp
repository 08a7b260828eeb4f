#include "image/image_data_check.h"

#include "image/jpeg_check.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace image {
namespace {

constexpr const char* cut_short = "the image is cut short; copy or save it again";

/// The parts of a TGA header that say where its pixels are. Truevision TGA File Format Specification 2.0,
/// "TGA file header".
struct TgaHeader
{
    static constexpr std::size_t SIZE = 18;

    explicit TgaHeader(std::span<const std::uint8_t> bytes)
        : id_length(bytes[0]), has_palette(bytes[1] == 1), run_length_encoded(bytes[2] >= 8),
          palette_start(bytes[3] + 256 * bytes[4]), palette_length(bytes[5] + 256 * bytes[6]),
          palette_entry_bytes((bytes[7] + 7) / 8), pixel_bytes((bytes[16] + 7) / 8),
          from_right_to_left((bytes[17] & 0x10) != 0)
    {}

    /// Where the pixels begin. stb_image takes the palette's first index for bytes to skip, and so do we.
    std::size_t data_offset() const
    {
        return SIZE + id_length + (has_palette ? palette_start + palette_length * palette_entry_bytes : 0);
    }

    std::size_t id_length;
    bool has_palette;
    bool run_length_encoded;
    std::size_t palette_start;
    std::size_t palette_length;
    std::size_t palette_entry_bytes;
    std::size_t pixel_bytes;
    bool from_right_to_left;
};

/// Follows the packets of a run-length encoded TGA to their end; npos-like (past the end) when they are cut
/// short.
std::size_t end_of_packets(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t pixel_bytes,
                           long long pixels)
{
    while (pixels > 0 && at < bytes.size()) {
        const int count = 1 + (bytes[at] & 0x7F);
        const bool repeats = (bytes[at] & 0x80) != 0;
        at += 1 + pixel_bytes * (repeats ? 1 : count);
        pixels -= count;
    }
    return pixels > 0 ? bytes.size() + 1 : at;
}

std::string check_tga(std::span<const std::uint8_t> bytes, long long pixels)
{
    if (bytes.size() < TgaHeader::SIZE) {
        return cut_short;
    }
    const TgaHeader header(bytes);
    if (header.from_right_to_left) {
        return "the TGA image is stored from right to left, which is not supported; save it as PNG";
    }
    const std::size_t begin = header.data_offset();
    const std::size_t end = header.run_length_encoded
                                ? end_of_packets(bytes, begin, header.pixel_bytes, pixels)
                                : begin + static_cast<std::size_t>(pixels) * header.pixel_bytes;
    return end > bytes.size() ? cut_short : "";
}

} // namespace

ImageFormat image_format(std::span<const std::uint8_t> bytes)
{
    static constexpr std::array<std::uint8_t, 8> PNG_SIGNATURE = {0x89, 'P',  'N',  'G',
                                                                  '\r', '\n', 0x1A, '\n'};
    if (bytes.size() >= PNG_SIGNATURE.size() &&
        std::equal(PNG_SIGNATURE.begin(), PNG_SIGNATURE.end(), bytes.begin())) {
        return ImageFormat::png;
    }
    const auto not_fill =
        std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte != 0xFF; });
    const bool is_jpeg = not_fill != bytes.begin() && not_fill != bytes.end() && *not_fill == 0xD8;
    return is_jpeg ? ImageFormat::jpeg : ImageFormat::tga_or_unknown;
}

std::string check_image_before_header(ImageFormat format, std::span<const std::uint8_t> bytes)
{
    return format == ImageFormat::jpeg ? check_jpeg_tables(bytes) : "";
}

std::string check_image_data(ImageFormat format, std::span<const std::uint8_t> bytes, long long pixels)
{
    if (format == ImageFormat::jpeg) {
        return check_jpeg_scans(bytes, pixels);
    }
    return format == ImageFormat::tga_or_unknown ? check_tga(bytes, pixels) : "";
}

} // namespace image
