#include "particles/flight.h"

namespace particles {

double time_of_reach(double air_resistance, double reach)
{
    // Newton's method. Reach grows ever more slowly, so from 0 every step falls short of the solution or hits
    // it: the times only grow, until rounding hides what is left of the way.
    constexpr int MAX_STEPS = 200;
    double seconds = 0.0;
    for (int i = 0; i < MAX_STEPS; ++i) {
        const Flight so_far = flight(air_resistance, seconds);
        const double left = reach - so_far.reach;
        if (!(left > reach * 0x1p-52) || so_far.keep < 0x1p-60) {
            break;
        }
        seconds += left / so_far.keep;
    }
    return seconds;
}

} // namespace particles
