#include "app/links/links.h"
#include "app/links/tasks.h"
#include "app/state/fields.h"
#include "tests/mesh/sample_files.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

// Writes what fuzzing starts from: fuzz_seeds FOLDER makes FOLDER/obj, FOLDER/image and FOLDER/link.

namespace {

void write(const std::filesystem::path& folder, int number, const Bytes& bytes)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / std::to_string(number), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

void write_text(const std::filesystem::path& folder, int number, const std::string& text)
{
    write(folder, number, Bytes(text.begin(), text.end()));
}

void write_objs(const std::filesystem::path& folder)
{
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
        write_text(folder, number++, text);
    }
}

void write_images(const std::filesystem::path& folder)
{
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
    int number = 0;
    for (const Bytes& image : images) {
        write(folder, number++, image);
    }
}

/// Every task and figure, each field at its ends, and what people and mailers make of links.
void write_links(const std::filesystem::path& folder)
{
    int number = 0;
    for (const app::Task& task : app::tasks()) {
        write_text(folder, number++,
                   std::string(app::link_key(task.kind)) + '=' + std::string(task.id) + '&' +
                       std::string(task.link));
    }
    for (const app::Field& field : app::fields()) {
        for (const std::int64_t end : {app::grid_minimum(field), app::grid_maximum(field)}) {
            app::State state;
            app::set_grid_value(field, state, end);
            write_text(folder, number++, app::link(state));
        }
    }
    for (const char* const text :
         {"#turret=30&gun=-8.5&event=fire&tick=12&seed=7", "event=open;tick=3",
          " Turret = +30.;&wheels=%2d8%2E5&x=1&x=2", "gun=up&turet=1&y=8,5&z=1e5&=&ground=maybe&%4",
          "event=none&tick=999999&seed=0"}) {
        write_text(folder, number++, text);
    }
}

} // namespace

int main(int argument_count, char** arguments)
{
    if (argument_count != 2) {
        std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
        return 1;
    }
    const std::filesystem::path folder = arguments[1];
    write_objs(folder / "obj");
    write_images(folder / "image");
    write_links(folder / "link");
    return 0;
}
