#include "lod/threshold.h"

#include <algorithm>
#include <cmath>

namespace lod {

CheckedThreshold checked_threshold(double wanted, double near_plane, double in_use)
{
    if (!std::isfinite(wanted)) {
        return {in_use, ThresholdFault::not_finite};
    }
    if (wanted < near_plane) {
        return {near_plane, ThresholdFault::below_near_plane};
    }
    return {wanted, ThresholdFault::none};
}

std::string_view threshold_fault_text(ThresholdFault fault)
{
    switch (fault) {
    case ThresholdFault::none:
        return "";
    case ThresholdFault::not_finite:
        return "The threshold distance must be a number; the old one stays.";
    case ThresholdFault::below_near_plane:
        return "The threshold distance cannot be nearer than the near plane; it is there now.";
    }
    return "";
}

SwitchBand band_by_fraction(double threshold, double fraction)
{
    const double used = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0; // 0 for not-a-number, too
    return {threshold * (1.0 - used), threshold * (1.0 + used)};
}

SwitchBand band_by_metres(double threshold, double metres)
{
    const double used = metres > 0.0 ? metres : 0.0;
    return {std::max(threshold - used, 0.0), threshold + used};
}

} // namespace lod
