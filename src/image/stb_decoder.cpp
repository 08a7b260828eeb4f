#include "image/stb_decoder.h"

#include "image/image.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

// The only file that includes stb_image. On damaged files it does what C++ leaves undefined; compiler options
// (see CMakeLists.txt) make that harmless, and the same natively and on the web:
// - its cosine transform overflows its integers (-fwrapv);
// - it copies no bytes to a null pointer (-fno-delete-null-pointer-checks, -fno-sanitize=nonnull-attribute);
// - where a scan ends too early it shifts by more than 31 bits, but only zeros
// (-fno-sanitize=shift-exponent). What it must not be given at all is found by jpeg_check.h,
// image_data_check.h and png_palette.h.

namespace {

// The largest block of memory that stb_image gets. Otherwise a PNG that unpacks without end would take all
// there is.
thread_local std::size_t largest_block = 0;

void allow_blocks_for(const image::ImageHeader& header, std::size_t file_bytes)
{
    constexpr std::size_t MARGIN = 64; // JPEG's blocks of 8 x 8 reach beyond the edges, sampled 4 x 4 at most
    constexpr std::size_t BYTES_PER_PIXEL = 8; // 16-bit RGBA
    constexpr std::size_t TABLES = 65536;
    largest_block =
        std::max((header.width + MARGIN) * (header.height + MARGIN) * BYTES_PER_PIXEL, 2 * file_bytes) +
        TABLES;
}

// Zeroed: where a damaged file leaves part of a picture out, the result must not depend on what was in
// memory.
void* allocate(std::size_t size)
{
    return size <= largest_block ? std::calloc(1, size) : nullptr;
}

void* reallocate(void* block, std::size_t old_size, std::size_t size)
{
    void* moved = size <= largest_block ? std::realloc(block, size) : nullptr;
    const std::size_t kept = block != nullptr ? old_size : 0;
    if (moved != nullptr && size > kept) {
        std::memset(static_cast<std::uint8_t*>(moved) + kept, 0, size - kept);
    }
    return moved;
}

} // namespace

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_SIMD // its decoders for SSE2 and NEON round differently from the one the web gets
#define STBI_MAX_DIMENSIONS image::MAX_IMAGE_SIDE
#define STBI_MALLOC(size) allocate(size)
#define STBI_REALLOC_SIZED(block, old_size, size) reallocate(block, old_size, size)
#define STBI_FREE(block) std::free(block)
#include <stb/stb_image.h>

namespace image {

bool read_image_header(std::span<const std::uint8_t> bytes, ImageHeader& header)
{
    stbi__g_failure_reason = nullptr; // it keeps the last one, and does not always set one
    allow_blocks_for({}, bytes.size());
    return stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &header.width, &header.height,
                                 &header.channels) != 0;
}

DecodedImage decode_image(std::span<const std::uint8_t> bytes, const ImageHeader& expected)
{
    stbi__g_failure_reason = nullptr;
    allow_blocks_for(expected, bytes.size());
    DecodedImage image;
    ImageHeader& header = image.header;
    image.pixels.reset(stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &header.width,
                                             &header.height, &header.channels, 0));
    return image;
}

std::string_view decoder_failure()
{
    const char* reason = stbi_failure_reason();
    return reason != nullptr ? reason : "no reason given";
}

} // namespace image
