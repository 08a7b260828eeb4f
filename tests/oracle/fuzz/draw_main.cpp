// Draws random programs as it is asked to: linked once with legacygl and once with the system's OpenGL.
//
// Reads lines from its input and answers each on its output:
//   SEED [INDEX ...]    draws the program, or only those of its calls: how many bytes, and the bytes of
//                       SIZE × SIZE pixels of four bytes followed by what was told (errors)
//   version             says the OpenGL's: how many bytes, and the bytes

#include "fuzz/fuzz_program.h"

#include "drawing.h"
#include "platform/offscreen/offscreen_target.h"

#include <GL/gl.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>

namespace {

using oracle::fuzz::SIZE;

std::string drawn(const random_gl::Program& program, const std::vector<std::size_t>& kept)
{
    std::string error;
    const auto target = platform::open_offscreen_target(SIZE, SIZE, error);
    if (!target) {
        return error;
    }
    const oracle::Drawn drawn =
        oracle::draw({"", [&] { oracle::fuzz::run(program, kept); }, {}, {SIZE, SIZE}});
    return std::string(drawn.rgba.begin(), drawn.rgba.end()) + drawn.told;
}

std::string version()
{
    std::string error;
    const auto target = platform::open_offscreen_target(SIZE, SIZE, error);
    return target ? reinterpret_cast<const char*>(glGetString(GL_VERSION)) : error;
}

void answer(const std::string& bytes)
{
    std::cout << bytes.size() << '\n' << bytes << std::flush;
}

} // namespace

int main()
{
    for (std::string line; std::getline(std::cin, line);) {
        if (line == "version") {
            answer(version());
            continue;
        }
        std::istringstream words(line);
        unsigned seed = 0;
        words >> seed;
        const random_gl::Program program = oracle::fuzz::make_program(seed);
        std::vector<std::size_t> kept;
        for (std::size_t i; words >> i;) {
            kept.push_back(i);
        }
        answer(drawn(program, kept.empty() ? oracle::fuzz::all(program) : kept));
    }
    return 0;
}
