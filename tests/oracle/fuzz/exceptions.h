#pragma once

#include <array>

namespace oracle::fuzz {

/// A seed of the test whose picture differs, by how many pixels at most, and why.
struct SeedException
{
    unsigned seed;
    int pixels;
    const char* why;
};

/// The seeds of the test are 1 … TEST_SEEDS.
constexpr unsigned TEST_SEEDS = 60;

constexpr std::array<SeedException, 0> EXCEPTIONS = {};

} // namespace oracle::fuzz
