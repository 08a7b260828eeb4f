#pragma once

#include "legacygl/cpu_pipeline/viewport_transform.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace legacygl {

/// log2 and exp2 by the polynomials that Mesa's software renderer compiles a shader's pow() to: a highlight
/// of a vertex lit here and one lit by a shader are then the same. Arguments are finite; x of
/// approximate_log2 is positive.
inline float approximate_log2(float x)
{
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const float exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23 & 0xff) - 127);
    bits = (bits & 0x007fffffu) | 0x3f800000u;
    float mantissa;
    std::memcpy(&mantissa, &bits, sizeof mantissa);
    const float y = (mantissa - 1) / (mantissa + 1), z = y * y, zz = z * z;
    const float even =
        fused(zz, fused(zz, 0.406718052498846252698f, 0.577440339438736392009f), 2.88539009343309178325f);
    const float odd = fused(zz, 0.403343858251329912514f, 0.961791550404184197881f);
    return fused(y, fused(odd, z, even), exponent);
}

inline float approximate_exp2(float x)
{
    x = std::fmax(std::fmin(x, 128.0f), -126.99999f);
    const float whole = std::floor(x), f = x - whole, ff = f * f;
    const std::uint32_t bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(whole) + 127) << 23;
    float power;
    std::memcpy(&power, &bits, sizeof power);
    const float even = fused(ff, fused(ff, 0.00898934009049466391101f, 0.240153617044375388211f), 1.0f);
    const float odd =
        fused(ff, fused(ff, 0.00187757667519147912699f, 0.0558263180532956664775f), 0.693153073200168932794f);
    return power * fused(odd, f, even);
}

/// x to the power y, for x >= 0; 0 for x = 0 whatever y is.
inline float approximate_pow(float x, float y)
{
    return x == 0 ? 0.0f : approximate_exp2(approximate_log2(x) * y);
}

} // namespace legacygl
