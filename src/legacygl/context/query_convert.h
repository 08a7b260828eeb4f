#pragma once

#include "legacygl/context/query.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace legacygl {

/// Writes the values as a query of type T returns them (OpenGL 1.5, 6.1.2): integers are rounded, and a
/// fraction is spread over all of them, the greatest for 1.
template <class T> void write_values(const QueryValue& value, T* params)
{
    for (int i = 0; i < value.count; ++i) {
        const double v = value.values[i];
        if constexpr (std::is_same_v<T, GLboolean>) {
            params[i] = v != 0 ? GL_TRUE : GL_FALSE;
        } else if constexpr (std::is_same_v<T, GLint>) {
            params[i] = static_cast<GLint>(std::clamp(
                value.kind == QueryValue::Kind::fraction ? std::trunc(v * 2147483647.0) : std::round(v),
                -2147483648.0, 2147483647.0));
        } else {
            params[i] = static_cast<T>(v);
        }
    }
}

} // namespace legacygl
