#include "lod/threshold.h"

#include <algorithm>

namespace lod {

SwitchBand band_by_fraction(double threshold, double fraction)
{
    const double used = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0; // 0 for not-a-number, too
    return {threshold * (1.0 - used), threshold * (1.0 + used)};
}

} // namespace lod
