// Draws every scene into a folder: <scene>.rgba (WIDTH × HEIGHT pixels of four bytes, the bottom row first)
// and <scene>.txt (what the scene told and the error it left); and version, the OpenGL's. Linked once with
// legacygl and once with the system's OpenGL; compare_test then holds the two folders together, and
// tests/page/oracle.test.mjs the page. Linked with an unchecked legacygl, too, which draws what a checked one
// drew without an error.

#include "drawing.h"
#include "platform/offscreen/offscreen_target.h"

#include <GL/gl.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

namespace {

void write(const std::string& path, const void* data, std::size_t size)
{
    std::ofstream(path, std::ios::binary).write(static_cast<const char*>(data), static_cast<long>(size));
}

bool chosen(const std::string& choice, const std::string& scene)
{
    if (!choice.starts_with('+')) {
        return choice.empty() || choice == scene;
    }
    const std::string drawn = choice.substr(1) + "/" + scene;
    return std::filesystem::exists(drawn + ".rgba") && !std::filesystem::exists(drawn + ".erred");
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 3) {
        std::fprintf(stderr, "usage: %s FOLDER [SCENE | +FOLDER]\n", argv[0]);
        std::fprintf(stderr, "  +FOLDER: only the scenes drawn there, and without an OpenGL error\n");
        return 2;
    }
    const std::string folder = argv[1], choice = argc == 3 ? argv[2] : "";
    std::string renderer = "nothing", version;
    int count = 0;
    for (const oracle::Scene& scene : oracle::scenes()) {
        if (!chosen(choice, scene.name)) {
            continue;
        }
        std::string error;
        const auto target = platform::open_offscreen_target(scene.size.width, scene.size.height, error);
        if (!target) {
            std::fprintf(stderr, "%s\n", error.c_str());
            return 2;
        }
        renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        const oracle::Drawn drawn = oracle::draw(scene);
        write(folder + "/" + scene.name + ".rgba", drawn.rgba.data(), drawn.rgba.size());
        write(folder + "/" + scene.name + ".txt", drawn.told.data(), drawn.told.size());
        const std::string erred = folder + "/" + scene.name + ".erred";
        drawn.erred ? write(erred, "", 0) : static_cast<void>(std::filesystem::remove(erred));
        ++count;
    }
    write(folder + "/version", version.data(), version.size());
    std::printf("%d scenes on %s\n", count, renderer.c_str());
    return 0;
}
