#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>

namespace image {

/// What stb_image finds in the header of a file.
struct ImageHeader
{
    int width = 0;
    int height = 0;
    int channels = 0; ///< 1: grey; 2: and alpha; 3: red, green, blue; 4: and alpha
};

struct FreeMemory
{
    void operator()(std::uint8_t* block) const { std::free(block); }
};

/// What stb_image makes of a file: rows from the top down, tightly packed.
struct DecodedImage
{
    ImageHeader header;
    std::unique_ptr<std::uint8_t, FreeMemory> pixels; ///< none: failed
};

/// Reads the header of a PNG, JPEG or TGA. False: failed.
bool read_image_header(std::span<const std::uint8_t> bytes, ImageHeader& header);

/// Decodes a PNG, JPEG or TGA. `expected` bounds the memory that is used: {} for hardly any, when only the
/// reason of a failure is wanted.
DecodedImage decode_image(std::span<const std::uint8_t> bytes, const ImageHeader& expected);

/// Returns stb_image's few words on why the last call in this thread failed.
std::string_view decoder_failure();

} // namespace image
