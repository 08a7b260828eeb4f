#pragma once

#include <string>

namespace legacygl {

/// group[index], an element of a uniform array.
inline std::string at(const char* group, int index)
{
    return std::string(group) + '[' + std::to_string(index) + ']';
}

/// column 0 · v.x + column 1 · v.y + …, added in that order.
inline std::string columns_times(const char* group, int first, const std::string& v)
{
    return v + ".x * " + at(group, first) + " + " + v + ".y * " + at(group, first + 1) + " + " + v + ".z * " +
           at(group, first + 2) + " + " + v + ".w * " + at(group, first + 3);
}

} // namespace legacygl
