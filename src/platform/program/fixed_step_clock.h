#pragma once

#include <algorithm>

namespace platform {

/// Turns the time between frames into whole ticks of the simulation and keeps the remainder.
class FixedStepClock
{
public:
    explicit FixedStepClock(int ticks_per_second) : ticks_per_second_(ticks_per_second) {}

    /// Returns the ticks that are due after `seconds` more.
    /// A long pause (a hidden page, a debugger) counts as a quarter of a second: the program goes on where it
    /// was. seconds: a negative or NaN time counts as none.
    int ticks_after(double seconds)
    {
        constexpr double LONGEST = 0.25;
        due_ += (seconds > 0.0 ? std::min(seconds, LONGEST) : 0.0) * ticks_per_second_;
        const int ticks = static_cast<int>(due_);
        due_ -= ticks;
        return ticks;
    }

private:
    int ticks_per_second_;
    double due_ = 0.0; // ticks, below 1 between calls
};

} // namespace platform
