#pragma once

namespace lod {

/// Holds the distances, in metres, at which the level is switched: 0 <= inner <= threshold <= outer.
/// Between inner and outer the level stays what it is.
struct SwitchBand
{
    double inner; ///< nearer than this it becomes high
    double outer; ///< further than this it becomes low
};

/// Half the width of the band that is shipped, as a fraction of d: 2 m either side at 100 m, far more than a
/// hand trembles and less than anybody would call another distance.
constexpr double DEFAULT_BAND_FRACTION = 0.02;

/// Returns the band d * (1 - fraction) .. d * (1 + fraction). A fraction that is negative or not a number
/// counts as 0, which is no hysteresis; one above 1 as 1. Precondition: threshold is finite, at least 0.
SwitchBand band_by_fraction(double threshold, double fraction = DEFAULT_BAND_FRACTION);

} // namespace lod
