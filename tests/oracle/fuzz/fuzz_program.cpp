#include "fuzz/fuzz_program.h"

#include "random_gl/random_stream.h"

#include <numeric>

namespace oracle::fuzz {

random_gl::Program make_program(unsigned seed)
{
    random_gl::RandomStream stream(seed);
    stream.set_up();
    stream.make(6 + stream.pick(16));
    return stream.program();
}

std::vector<std::size_t> all(const random_gl::Program& program)
{
    std::vector<std::size_t> indices(program.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
}

void run(const random_gl::Program& program, const std::vector<std::size_t>& kept)
{
    random_gl::RandomStream::make_textures();
    // Without a window the one is empty at first, and what is in the others undefined.
    glScissor(0, 0, SIZE, SIZE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    program.run(kept);
}

} // namespace oracle::fuzz
