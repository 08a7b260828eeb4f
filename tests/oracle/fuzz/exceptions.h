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
    SeedException{5, 1, "The last bit of a colour, see LAST_BIT_DECIDES in scene.h: by 1.", {26}},
    SeedException{7, 1, "The same.", {26}},
    SeedException{25, 220, "The last bit of a depth, which decides what is in front.", {26}},
    SeedException{34, 13, "The same.", {26}},
    SeedException{59, 16, "Smooth lines at the same depth, as above.", {23}},
};

} // namespace oracle::fuzz
