#pragma once

#include <string>

namespace legacygl {

/// group[index], an element of a uniform array.
inline std::string at(const char* group, int index)
{
    return std::string(group) + '[' + std::to_string(index) + ']';
}

/// An element of the vertex's own slot of the uniform array `transform`, see TransformLayout.
inline std::string of_transform(int index)
{
    return "transform[slot + " + std::to_string(index) + "]";
}

/// column 0 · v.x + column 1 · v.y + …, added in that order. column(i) names the column i.
template <class Column> std::string columns_times(Column column, const std::string& v)
{
    return v + ".x * " + column(0) + " + " + v + ".y * " + column(1) + " + " + v + ".z * " + column(2) +
           " + " + v + ".w * " + column(3);
}

} // namespace legacygl
