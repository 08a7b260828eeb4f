#pragma once

#include <numbers>

namespace scene {

/// Returns an angle in radians as the degrees that glRotatef takes, rounded once.
inline float degrees(double radians)
{
    return static_cast<float>(radians * 180.0 / std::numbers::pi);
}

} // namespace scene
