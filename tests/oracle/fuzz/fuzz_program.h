#pragma once

#include "random_gl/program.h"

#include <vector>

namespace oracle::fuzz {

/// Pictures are SIZE × SIZE.
constexpr int SIZE = 96;

/// Returns the random program of a seed.
random_gl::Program make_program(unsigned seed);

/// Returns the indices of all calls.
std::vector<std::size_t> all(const random_gl::Program& program);

/// Makes the textures that random programs bind and then the calls of these indices.
void run(const random_gl::Program& program, const std::vector<std::size_t>& kept);

} // namespace oracle::fuzz
