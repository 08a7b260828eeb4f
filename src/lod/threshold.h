#pragma once

#include <cstdint>
#include <string_view>

namespace lod {

/// Says what was wrong with a threshold that somebody asked for.
enum class ThresholdFault : std::uint8_t
{
    none,
    not_finite,       ///< refused: the one in use stays
    below_near_plane, ///< brought up to the near plane; negative ones, too
};

/// Holds a distance that can be used as the threshold d, metres, and what had to be done to get it.
struct CheckedThreshold
{
    double distance;
    ThresholdFault fault;
};

/// Returns the threshold that takes the place of `in_use` when `wanted` is asked for. Metres.
/// Nothing nearer than the near plane is drawn, so a nearer threshold would mean "always low" in a way that
/// nobody could see or undo by moving; it becomes the near plane's distance. A threshold beyond the far plane
/// is as good as any: always high. Precondition: near_plane > 0, in_use >= near_plane.
CheckedThreshold checked_threshold(double wanted, double near_plane, double in_use);

/// Returns the sentence to be shown, such as "The threshold ...", or "" for none.
std::string_view threshold_fault_text(ThresholdFault fault);

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

/// Returns the band d - metres .. d + metres, its inner end at least 0. A width that is negative or not a
/// number counts as 0. Precondition: threshold is finite, at least 0.
SwitchBand band_by_metres(double threshold, double metres);

} // namespace lod
