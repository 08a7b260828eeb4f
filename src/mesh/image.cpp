#include "mesh/image.h"

#include "mesh/image_data_check.h"
#include "mesh/quoted.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

namespace {

// stb_image asks for memory before it knows whether the file can fill it. 8 bytes a pixel is what its largest
// picture takes (16-bit RGBA); no file that is read needs a larger block, but a PNG that unpacks without end
// would take one.
constexpr std::size_t largest_block = (std::size_t{1} << 25) * 8 + (std::size_t{1} << 22);

// Zeroed: where a damaged JPEG leaves part of the picture out, the result must not depend on what was in
// memory.
void* allocate(std::size_t size)
{
    return size <= largest_block ? std::calloc(1, size) : nullptr;
}

void* reallocate(void* block, std::size_t size)
{
    return size <= largest_block ? std::realloc(block, size) : nullptr;
}

} // namespace

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_SIMD // its decoders for SSE2 and NEON round differently from the one the web gets
#define STBI_NO_THREAD_LOCALS
#define STBI_MAX_DIMENSIONS mesh::max_image_side
#define STBI_MALLOC(size) allocate(size)
#define STBI_REALLOC(block, size) reallocate(block, size)
#define STBI_FREE(block) std::free(block)
#include <stb/stb_image.h>

namespace mesh {
namespace {

constexpr const char* not_an_image = "the file is not a PNG, JPEG or TGA image; save it as one of these";

std::string too_large()
{
    return "the image is too large: at most " + std::to_string(max_image_side) + " pixels a side and " +
           std::to_string(max_image_pixels) + " in all are read; scale it down";
}

/// Turns stb_image's short reason for its last failure into a sentence.
std::string failure_sentence()
{
    const char* reason = stbi_failure_reason();
    const std::string_view r = reason != nullptr ? reason : "no reason given";
    if (r == "unknown image type")
        return not_an_image;
    if (r == "too large")
        return too_large();
    if (r == "outofmem")
        return "the image needs more memory than is allowed for one; scale it down or save it again";
    if (r == "only 8-bit" || r == "1/2/4/8/16-bit only")
        return "the image has an unusual number of bits per channel; save it with 8";
    return "the image is damaged or cut short (" + quoted(r) + "); copy or save it again";
}

/// Frees what stb_image returned.
struct FreePixels
{
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};
using DecodedPixels = std::unique_ptr<stbi_uc, FreePixels>;

/// Copies one row, making three or four channels of one or two.
void copy_row(const stbi_uc* from, int channels, int width, std::uint8_t* to)
{
    if (channels >= 3) {
        std::memcpy(to, from, static_cast<std::size_t>(width) * channels);
        return;
    }
    for (int x = 0; x < width; ++x, from += channels) {
        to = std::fill_n(to, 3, from[0]);
        if (channels == 2)
            *to++ = from[1];
    }
}

/// Makes an Image of pixels whose rows come from the top down.
Image flipped_and_expanded(const stbi_uc* decoded, int width, int height, int channels)
{
    Image image{width, height, channels >= 3 ? channels : channels + 2, {}};
    const std::size_t row_bytes = static_cast<std::size_t>(width) * image.channels;
    const std::size_t decoded_row_bytes = static_cast<std::size_t>(width) * channels;
    image.pixels.resize(row_bytes * height);
    for (int y = 0; y < height; ++y)
        copy_row(decoded + decoded_row_bytes * (height - 1 - y), channels, width,
                 image.pixels.data() + row_bytes * y);
    return image;
}

} // namespace

Result<Image> read_image(std::string_view file_name, std::span<const std::uint8_t> bytes)
{
    const auto failure = [&](std::string cause) {
        return ReadError{std::string(file_name), 0, std::move(cause)};
    };
    if (bytes.empty())
        return failure("the file is empty");
    if (bytes.size() > max_image_file_bytes)
        return failure("the file has " + std::to_string(bytes.size() >> 20) + " MB and at most " +
                       std::to_string(max_image_file_bytes >> 20) + " MB are read; scale the image down");

    stbi__g_failure_reason = nullptr; // it keeps the last one, and does not always set one
    const ImageFormat format = image_format(bytes);
    int width = 0;
    int height = 0;
    int channels = 0;
    const int size = static_cast<int>(bytes.size());
    const auto decode = [&] {
        return DecodedPixels(stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 0));
    };
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) {
        if (format != ImageFormat::tga_or_unknown)
            decode(); // fails at the same header, but says why
        return failure(failure_sentence());
    }
    const long long pixels = static_cast<long long>(width) * height;
    if (width > max_image_side || height > max_image_side || pixels > max_image_pixels)
        return failure(too_large());
    if (std::string cause = check_image_data(format, bytes, pixels); !cause.empty())
        return failure(std::move(cause));

    const DecodedPixels decoded = decode();
    if (!decoded)
        return failure(failure_sentence());
    return flipped_and_expanded(decoded.get(), width, height, channels);
}

} // namespace mesh
