#pragma once

#include "lod/level.h"
#include "lod/threshold.h"

namespace lod {

/// Returns the level for a distance, in metres from the eye, when there is no level yet: low beyond the
/// threshold, high at it, inside it, and for not-a-number.
Level level_at(double distance, double threshold);

/// Returns the level that follows `current` at a distance: low beyond the band, high inside it, the same
/// within it and for not-a-number. So a crossing of the whole band, at any speed, with any trembling on the
/// way, switches exactly once, and trembling within the band not at all.
Level next_level(Level current, double distance, const SwitchBand& band);

/// Remembers the level of one tank for one viewer. Plain data; it belongs to the viewer, not to a link: where
/// a tank that came from afar is still low, one opened there by a link is high.
struct LevelSelector
{
    Level level = Level::high; ///< by distance

    /// Forgets what was before, as when a link is opened.
    void start(double distance, double threshold) { level = level_at(distance, threshold); }

    /// Takes in the distance, in metres from the eye; call it once a step. Returns whether the level
    /// switched.
    bool update(double distance, const SwitchBand& band);

    friend bool operator==(const LevelSelector&, const LevelSelector&) = default;
};

} // namespace lod
