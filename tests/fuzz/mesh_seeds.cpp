#include "tests/mesh/sample_files.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

// Writes the valid files that fuzzing starts from: mesh_seeds FOLDER makes FOLDER/obj and FOLDER/image.

namespace {

void write(const std::filesystem::path& folder, int number, const Bytes& bytes)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / std::to_string(number), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

} // namespace

int main(int argument_count, char** arguments)
{
    if (argument_count != 2) {
        std::fputs("usage: mesh_seeds FOLDER\n", stderr);
        return 1;
    }
    const std::filesystem::path folder = arguments[1];
    const std::string texts[] = {
        sample_obj(),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\ns 2\nf 1 2 3 4 5 6\n",
        "v .5 -1e-3 2.\\\n\r\nv 1 0 0 1\rv 0 1 0 1 1 1\nvt 0\nvt 0 1 0\nvn 0 0 0\nf -1/1/1 -2/2/-1 -3/1/1 # "
        "c\n",
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\ns 1\nf 1 2 3 4 1 5 6 7 8 "
        "5\nf 4//\n",
    };
    int number = 0;
    for (const std::string& text : texts) {
        write(folder / "obj", number++, Bytes(text.begin(), text.end()));
    }

    const Bytes palette = png_chunk("PLTE", {1, 2, 3, 40, 50, 60});
    Bytes with_alpha = palette;
    for (const std::uint8_t byte : png_chunk("tRNS", {128})) {
        with_alpha.push_back(byte);
    }
    const Bytes images[] = {
        png_file(sample_picture(9, 5, 3)),
        png_file(sample_picture(9, 5, 4)),
        png_file(sample_picture(9, 5, 1)),
        png_file(sample_picture(9, 5, 2)),
        raw_png(3, 2, 8, 3, {{1, 0, 1}, {0, 0, 1}}, palette),
        raw_png(3, 2, 1, 3, {{0xA0}, {0x40}}, with_alpha),
        raw_png(2, 2, 16, 6, {Bytes(16, 1), Bytes(16, 2)}),
        raw_png(2, 1, 8, 0, {{10, 11}}, png_chunk("tRNS", {0, 10})),
        jpeg_file(sample_picture(17, 9, 3), 90),
        jpeg_file(sample_picture(17, 9, 3), 40),
        jpeg_file(sample_picture(8, 8, 1), 50),
        progressive_jpeg(),
        tga_file(sample_picture(9, 5, 3), false, false),
        tga_file(sample_picture(9, 5, 4), true, true),
        {0, 1, 1, 0, 0, 2, 0, 24, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0, 3, 2, 1, 60, 50, 40, 1, 0},
        {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 16, 0, 0xFF, 0x7F, 0x00, 0x7C},
        {0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 8, 0, 0x81, 6},
    };
    number = 0;
    for (const Bytes& image : images) {
        write(folder / "image", number++, image);
    }
    return 0;
}
