#include "app/measures.h"

#include "app/decimal.h"

#include <algorithm>
#include <cmath>

namespace app {

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

} // namespace app
