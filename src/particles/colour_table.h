#pragma once

#include "particles/settings.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace particles {

/// A colour as glColor4ubv takes it: not premultiplied, 255 is full.
struct Rgba
{
    std::uint8_t red;
    std::uint8_t green;
    std::uint8_t blue;
    std::uint8_t alpha;

    friend bool operator==(const Rgba&, const Rgba&) = default;
};

/// The colours of a ramp in equal steps of a life, from its start to its end.
using ColourTable = std::array<Rgba, 256>;

/// Computes the colours of a ramp, rounded to the nearest. Precondition: validate() has nothing against it.
ColourTable colour_table(const ColourRamp& ramp);

} // namespace particles
