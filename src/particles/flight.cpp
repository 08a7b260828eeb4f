#include "particles/flight.h"

#include <array>
#include <cstddef>

namespace particles {

namespace {

/// Beyond this k t the time is halved first. The first term left out is then 2^-40 / 10!, beside 1 / 2!.
constexpr double longest_series = 1.0 / 32.0;

/// 1 / (n + 2)! with alternating signs: (e^-y - 1 + y) / y^2 = 1/2! - y/3! + y^2/4! - ...
constexpr std::array<double, 8> series = [] {
    std::array<double, 8> terms{};
    double factorial = 1.0;
    for (int n = 0; n < 8; ++n) {
        factorial *= n + 2;
        terms[static_cast<std::size_t>(n)] = (n % 2 == 0 ? 1.0 : -1.0) / factorial;
    }
    return terms;
}();

Flight short_flight(double air_resistance, double seconds)
{
    const double y = air_resistance * seconds;
    double sum = 0.0;
    for (auto term = series.rbegin(); term != series.rend(); ++term) {
        sum = sum * y + *term;
    }
    return {seconds, 1.0 - y * (1.0 - y * sum), seconds * (1.0 - y * sum), seconds * seconds * sum};
}

} // namespace

Flight flight(double air_resistance, double seconds)
{
    int doublings = 0;
    double part = seconds;
    while (air_resistance * part > longest_series) {
        part *= 0.5;
        ++doublings;
    }
    Flight result = short_flight(air_resistance, part);
    result.seconds = seconds;
    for (; doublings > 0; --doublings) {
        result.fall = 2.0 * result.fall + result.reach * result.reach;
        result.reach += result.reach * result.keep;
        result.keep *= result.keep;
    }
    return result;
}

double time_of_reach(double air_resistance, double reach)
{
    // Newton's method. Reach grows ever more slowly, so from 0 every step falls short of the solution or hits
    // it: the times only grow, until rounding hides what is left of the way.
    constexpr int most_steps = 200;
    double seconds = 0.0;
    for (int i = 0; i < most_steps; ++i) {
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
