#pragma once

#include <cstdint>

namespace scene {

/// A colour as glColor3ub takes it.
struct Rgb
{
    std::uint8_t red;
    std::uint8_t green;
    std::uint8_t blue;
};

} // namespace scene
