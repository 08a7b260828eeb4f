#include "particles/flight.h"

#include <array>
#include <cstddef>

namespace particles {

namespace {

/// Beyond this k t the time is halved first. At 0.5 the first term left out is 0.5^15 / 17!, below 2^-53.
constexpr double longest_series = 0.5;

/// 1 / (n + 2)! with alternating signs: (e^-y - 1 + y) / y^2 = 1/2! - y/3! + y^2/4! - ...
constexpr std::array<double, 15> series = [] {
    std::array<double, 15> terms{};
    double factorial = 1.0;
    for (int n = 0; n < 15; ++n) {
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
    return {1.0 - y * (1.0 - y * sum), seconds * (1.0 - y * sum), seconds * seconds * sum};
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
    // it: the times only grow, and stop growing where rounding lets them get no nearer.
    constexpr int most_steps = 200;
    double seconds = 0.0;
    for (int i = 0; i < most_steps; ++i) {
        const Flight so_far = flight(air_resistance, seconds);
        if (so_far.keep == 0.0) {
            break;
        }
        const double longer = seconds + (reach - so_far.reach) / so_far.keep;
        if (!(longer > seconds)) {
            break;
        }
        seconds = longer;
    }
    return seconds;
}

} // namespace particles
