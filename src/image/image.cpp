#include "image/image.h"

#include "base/quoted.h"
#include "image/image_data_check.h"
#include "image/png_palette.h"
#include "image/stb_decoder.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

namespace image {
namespace {

std::string too_large()
{
    return "the image is too large: at most " + std::to_string(MAX_IMAGE_SIDE) + " pixels a side and " +
           std::to_string(MAX_IMAGE_PIXELS) + " in all are read; scale it down";
}

/// Turns stb_image's few words on its last failure into a sentence.
std::string failure_sentence()
{
    const std::string_view reason = decoder_failure();
    if (reason == "unknown image type") {
        return "the file is not a PNG, JPEG or TGA image; save it as one of these";
    }
    if (reason == "too large") {
        return too_large();
    }
    if (reason == "outofmem") {
        return "the image needs more memory than is allowed for one; scale it down or save it again";
    }
    if (reason == "only 8-bit" || reason == "1/2/4/8/16-bit only") {
        return "the image has an unusual number of bits per channel; save it with 8";
    }
    return "the image is damaged or cut short (" + base::quoted(reason) + "); copy or save it again";
}

/// Copies one row, making three or four channels of one or two.
void copy_row(const std::uint8_t* from, int channels, int width, std::uint8_t* to)
{
    if (channels >= 3) {
        std::memcpy(to, from, static_cast<std::size_t>(width) * channels);
        return;
    }
    for (int x = 0; x < width; ++x, from += channels) {
        to = std::fill_n(to, 3, from[0]);
        if (channels == 2) {
            *to++ = from[1];
        }
    }
}

/// Makes an Image of rows that come from the top down.
Image flipped_and_expanded(const DecodedImage& decoded)
{
    const auto& [width, height, channels] = decoded.header;
    Image image{width, height, channels >= 3 ? channels : channels + 2, {}};
    const std::size_t row_bytes = static_cast<std::size_t>(width) * image.channels;
    const std::size_t decoded_row_bytes = static_cast<std::size_t>(width) * channels;
    image.pixels.resize(row_bytes * height);
    for (int y = 0; y < height; ++y) {
        copy_row(decoded.pixels.get() + decoded_row_bytes * (height - 1 - y), channels, width,
                 image.pixels.data() + row_bytes * y);
    }
    return image;
}

/// Returns what stands against decoding the file, if anything, and its header.
std::string check(std::span<const std::uint8_t> bytes, ImageHeader& header)
{
    if (bytes.empty()) {
        return "the file is empty";
    }
    if (bytes.size() > MAX_IMAGE_FILE_BYTES) {
        return "the file has " + std::to_string(bytes.size() >> 20) + " MB and at most " +
               std::to_string(MAX_IMAGE_FILE_BYTES >> 20) + " MB are read; scale the image down";
    }
    const ImageFormat format = image_format(bytes);
    if (std::string cause = check_image_before_header(format, bytes); !cause.empty()) {
        return cause;
    }
    if (!read_image_header(bytes, header)) {
        if (format != ImageFormat::tga_or_unknown) {
            decode_image(bytes, {}); // fails at the same header, but says why
        }
        return failure_sentence();
    }
    const long long pixels = static_cast<long long>(header.width) * header.height;
    if (header.width > MAX_IMAGE_SIDE || header.height > MAX_IMAGE_SIDE || pixels > MAX_IMAGE_PIXELS) {
        return too_large();
    }
    return check_image_data(format, bytes, pixels);
}

} // namespace

base::Result<Image> read_image(std::string_view file_name, std::span<const std::uint8_t> bytes)
{
    ImageHeader header;
    if (std::string cause = check(bytes, header); !cause.empty()) {
        return base::ReadError{std::string(file_name), 0, std::move(cause)};
    }
    std::vector<std::uint8_t> full;
    if (image_format(bytes) == ImageFormat::png) {
        full = png_with_full_palette(bytes);
    }
    const DecodedImage decoded = decode_image(full.empty() ? bytes : full, header);
    if (!decoded.pixels) {
        return base::ReadError{std::string(file_name), 0, failure_sentence()};
    }
    return flipped_and_expanded(decoded);
}

} // namespace image
