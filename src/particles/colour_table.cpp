#include "particles/colour_table.h"

namespace particles {

namespace {

/// middle_at 0 or 1: there is no way to or from the middle, only its colour.
glm::dvec4 colour_at(const ColourRamp& ramp, double part)
{
    const glm::dvec4 middle{ramp.middle};
    const auto middle_at = static_cast<double>(ramp.middle_at);
    if (part < middle_at) {
        const double way = part / middle_at;
        return glm::dvec4{ramp.start} * (1.0 - way) + middle * way;
    }
    const double way = middle_at < 1.0 ? (part - middle_at) / (1.0 - middle_at) : 0.0;
    return middle * (1.0 - way) + glm::dvec4{ramp.end} * way;
}

std::uint8_t to_byte(double channel)
{
    return static_cast<std::uint8_t>(channel * 255.0 + 0.5);
}

} // namespace

ColourTable colour_table(const ColourRamp& ramp)
{
    ColourTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const glm::dvec4 colour = colour_at(ramp, static_cast<double>(i) / (table.size() - 1));
        table[i] = {to_byte(colour.r), to_byte(colour.g), to_byte(colour.b), to_byte(colour.a)};
    }
    return table;
}

} // namespace particles
