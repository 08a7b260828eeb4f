// Measures the programs natively. Linked once with legacygl and once with the system's OpenGL; scripts/bench
// runs the two in turn.
//
//   immediate FRAMES, lists FRAMES   the wall time of each frame, drawing finished
//   compile ROUNDS                   of each round: compiling the long list, and what calling it the first
//   time
//                                    takes longer than calling it again; and a copy of its data with its
//                                    upload
//   picture PROGRAM FILE             writes what a frame shows, as SIZE × SIZE RGBA pixels
//
// Prints milliseconds, a figure a line (of `compile` two: list, copy).

#include "platform/offscreen/egl_context.h"
#include "platform/offscreen/offscreen_target.h"
#include "programs.h"

#include <GL/gl.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

template <class Work> double milliseconds(Work work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    return taken.count();
}

const bench::Program& program_named(const std::string& name)
{
    return name == "lists" ? bench::lists : bench::immediate;
}

void measure_frames(const bench::Program& program, int frames)
{
    constexpr int WARM_UP = 5;
    program.setup();
    for (int i = 0; i < WARM_UP + frames; ++i) {
        const double time = milliseconds([&] {
            program.frame(i);
            glFinish();
        });
        if (i >= WARM_UP) {
            std::printf("%.4f\n", time);
        }
    }
}

template <class Function> Function find(const char* name)
{
    return reinterpret_cast<Function>(platform::find_egl_function(name));
}

/// Copies the long list's data and uploads the copy, below whatever library is linked.
double copy_and_upload()
{
    constexpr GLenum ARRAY_BUFFER = 0x8892, STATIC_DRAW = 0x88E4;
    static const auto generate = find<void (*)(GLsizei, GLuint*)>("glGenBuffers");
    static const auto bind = find<void (*)(GLenum, GLuint)>("glBindBuffer");
    static const auto data = find<void (*)(GLenum, std::ptrdiff_t, const void*, GLenum)>("glBufferData");
    static const auto destroy = find<void (*)(GLsizei, const GLuint*)>("glDeleteBuffers");
    const std::size_t count = static_cast<std::size_t>(bench::LONG_TRIANGLES) * 3 * bench::LONG_FLOATS;
    const float* source = bench::long_list_vertices();
    GLuint buffer = 0;
    const double time = milliseconds([&] {
        const std::vector<float> copy(source, source + count);
        generate(1, &buffer);
        bind(ARRAY_BUFFER, buffer);
        data(ARRAY_BUFFER, static_cast<std::ptrdiff_t>(count * sizeof(float)), copy.data(), STATIC_DRAW);
    });
    bind(ARRAY_BUFFER, 0);
    destroy(1, &buffer);
    return time;
}

void measure_compiling(int rounds)
{
    bench::immediate.setup(); // for lighting and a texture, so that every attribute is used
    bench::long_list_vertices();
    glViewport(0, 0, 1, 1); // Filling is not what is measured.
    const GLuint list = glGenLists(1);
    const auto call = [list] {
        return milliseconds([list] {
            glCallList(list);
            glFinish();
        });
    };
    for (int i = 0; i < rounds + 1; ++i) {
        const double compiling = milliseconds([list] {
            glNewList(list, GL_COMPILE);
            bench::long_list();
            glEndList();
        });
        const double first = call();
        double later = call();
        for (int again = 0; again < 2; ++again) {
            later = std::min(later, call());
        }
        const double copying = copy_and_upload();
        if (i > 0) {
            std::printf("%.4f\n%.4f\n", compiling + std::max(0.0, first - later), copying);
        }
        glDeleteLists(list, 1);
    }
}

int write_picture(const bench::Program& program, const char* path)
{
    program.setup();
    program.frame(1);
    std::vector<unsigned char> pixels(static_cast<std::size_t>(bench::SIZE) * bench::SIZE * 4);
    glReadPixels(0, 0, bench::SIZE, bench::SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    std::FILE* file = std::fopen(path, "wb");
    if (file == nullptr || std::fwrite(pixels.data(), 1, pixels.size(), file) != pixels.size()) {
        return 2;
    }
    return std::fclose(file);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3) {
        std::fprintf(stderr, "usage: %s immediate|lists FRAMES, compile ROUNDS, picture PROGRAM FILE\n",
                     argv[0]);
        return 2;
    }
    std::string error;
    const auto target = platform::open_offscreen_target(bench::SIZE, bench::SIZE, error);
    if (!target) {
        std::fprintf(stderr, "%s\n", error.c_str());
        return 2;
    }
    const std::string what = argv[1];
    if (what == "picture" && argc == 4) {
        return write_picture(program_named(argv[2]), argv[3]);
    }
    if (what == "compile") {
        measure_compiling(std::atoi(argv[2]));
    } else {
        measure_frames(program_named(what), std::atoi(argv[2]));
    }
    return 0;
}
