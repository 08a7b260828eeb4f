#include "lod/level_selector.h"

namespace lod {

Level level_at(double distance, double threshold)
{
    return distance > threshold ? Level::low : Level::high;
}

Level next_level(Level current, double distance, const SwitchBand& band)
{
    if (distance > band.outer) {
        return Level::low;
    }
    if (distance < band.inner) {
        return Level::high;
    }
    return current;
}

bool LevelSelector::update(double distance, const SwitchBand& band)
{
    const Level before = level;
    level = next_level(before, distance, band);
    return level != before;
}

} // namespace lod
