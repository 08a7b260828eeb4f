// Draws every scene into a folder: <scene>.rgba (WIDTH × HEIGHT pixels of four bytes, the bottom row first)
// and <scene>.txt (what the scene told and the error it left). Linked once with legacygl and once with the
// system's OpenGL; compare_test then holds the two folders together, and tests/page/oracle.test.mjs the page.

#include "drawing.h"
#include "platform/offscreen_target.h"

#include <GL/gl.h>

#include <cstdio>
#include <fstream>
#include <memory>

namespace {

void write(const std::string& path, const void* data, std::size_t size)
{
    std::ofstream(path, std::ios::binary).write(static_cast<const char*>(data), static_cast<long>(size));
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "usage: %s FOLDER [SCENE]\n", argv[0]);
        return 2;
    }
    const std::string folder = argv[1];
    std::string renderer = "nothing";
    for (const oracle::Scene& scene : oracle::scenes()) {
        if (argc == 3 && std::string(argv[2]) != scene.name)
            continue;
        std::string error;
        const auto target = platform::open_offscreen_target(scene.size.width, scene.size.height, error);
        if (!target) {
            std::fprintf(stderr, "%s\n", error.c_str());
            return 2;
        }
        renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        const oracle::Drawn drawn = oracle::draw(scene);
        write(folder + "/" + scene.name + ".rgba", drawn.rgba.data(), drawn.rgba.size());
        write(folder + "/" + scene.name + ".txt", drawn.told.data(), drawn.told.size());
    }
    std::printf("%zu scenes on %s\n", oracle::scenes().size(), renderer.c_str());
    return 0;
}
