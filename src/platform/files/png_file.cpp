#include "platform/files/png_file.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace platform {
namespace {

/// Returns the rows top first and without alpha, as stb and PNG want them.
std::vector<std::uint8_t> top_first_rgb(int width, int height, std::span<const std::uint8_t> rgba)
{
    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(columns * rows * 3);
    for (std::size_t row = rows; row-- > 0;) {
        for (std::size_t column = 0; column < columns; ++column) {
            const std::uint8_t* pixel = &rgba[(row * columns + column) * 4];
            rgb.insert(rgb.end(), pixel, pixel + 3);
        }
    }
    return rgb;
}

void append(void* file_bytes, void* data, int size)
{
    auto* bytes = static_cast<std::vector<std::uint8_t>*>(file_bytes);
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes->insert(bytes->end(), begin, begin + size);
}

} // namespace

std::string write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgba)
{
    const std::vector<std::uint8_t> rgb = top_first_rgb(width, height, rgba);
    std::vector<std::uint8_t> bytes;
    if (stbi_write_png_to_func(append, &bytes, width, height, 3, rgb.data(), width * 3) == 0) {
        return "The picture for " + path + " could not be encoded as PNG.";
    }

    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) {
        return path + " cannot be written: " + std::strerror(errno) + ".";
    }
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    // A full disk often shows only when the buffer is flushed.
    const bool closed = std::fclose(file) == 0;
    if (written && closed) {
        return "";
    }
    const std::string cause = errno != 0 ? std::strerror(errno) : "the write was cut short";
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) { // never a device
        std::filesystem::remove(path, ignored);
    }
    return path + " could not be written whole: " + cause + ".";
}

} // namespace platform
