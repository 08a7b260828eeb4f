#pragma once

#include "mesa_version.h"

#include <array>

namespace oracle::fuzz {

/// A seed of the test whose picture differs, by how many pixels at most, why, and on which versions of Mesa.
struct SeedException
{
    unsigned seed;
    int pixels;
    const char* why;
    MesaVersions versions{};
};

/// The seeds of the test are 1 … TEST_SEEDS.
constexpr unsigned TEST_SEEDS = 60;

constexpr std::array EXCEPTIONS = {
    SeedException{50, 1, "A smooth line's corners pass through clip coordinates, which rounds them: by 1."},
    SeedException{
        59, 10, "Smooth lines over one another at the same depth, whose last bit is rounded.", {0, 22}},
    SeedException{59, 15, "The same.", {23}},
};

} // namespace oracle::fuzz
