#include "base/measures.h"

#include "base/decimal.h"

#include <algorithm>
#include <cmath>

namespace base {

std::int64_t to_millimetres(double metres)
{
    constexpr double LARGEST = 1e9;
    return std::llround(std::clamp(metres, -LARGEST, LARGEST) * 1000.0);
}

std::string in_metres(double metres)
{
    return write_decimal(to_millimetres(metres), 3);
}

std::string in_metres(const glm::dvec3& point)
{
    return "(" + in_metres(point.x) + ", " + in_metres(point.y) + ", " + in_metres(point.z) + ")";
}

std::string factor_text(double factor)
{
    constexpr double LEAST_OF_FOUR_DIGITS = 1000.0;
    constexpr int MAX_DECIMALS = 9;
    int decimals = 0;
    double shown = factor;
    for (; decimals < MAX_DECIMALS && shown < LEAST_OF_FOUR_DIGITS; ++decimals) {
        shown *= 10.0;
    }
    return write_decimal(std::llround(shown), decimals);
}

} // namespace base
