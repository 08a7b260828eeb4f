#pragma once

namespace particles {

/// Holds what a time t does to anything that obeys
///
///     dv/dt = a - k v        a: constant acceleration, k: air resistance
///
/// exactly, whatever t is:
///
///     v(t) = v(0) keep + a reach                   keep  = e^(-k t)
///     x(t) = x(0) + v(0) reach + a fall            reach = (1 - keep) / k,      t without air
///                                                  fall  = (t - reach) / k,     t^2 / 2 without air
///
/// Wind w is air that moves, dv/dt = g - k (v - w), which is the same with a = g + k w.
struct Flight
{
    double seconds; ///< t
    double keep;
    double reach;
    double fall;
};

/// Computes them for an air resistance in 1/s and a time in seconds; both finite and not negative.
/// The library's exp() is not the same everywhere. Here a power series gives a time so short that few terms
/// are exact, and is doubled until the time is reached: two equal flights in a row make one. Additions,
/// multiplications and divisions only, so the bits are the same on every machine.
inline Flight flight(double air_resistance, double seconds)
{
    // The first term left out is 2^-40 / 10!, beside 1 / 2!.
    constexpr double MAX_SERIES = 1.0 / 32.0;
    int doublings = 0;
    double part = seconds;
    while (air_resistance * part > MAX_SERIES) {
        part *= 0.5;
        ++doublings;
    }
    // (e^-y - 1 + y) / y^2 = 1/2! - y/3! + y^2/4! - ...
    const double y = air_resistance * part;
    double sum = -1.0 / 362880.0;
    sum = sum * y + 1.0 / 40320.0;
    sum = sum * y - 1.0 / 5040.0;
    sum = sum * y + 1.0 / 720.0;
    sum = sum * y - 1.0 / 120.0;
    sum = sum * y + 1.0 / 24.0;
    sum = sum * y - 1.0 / 6.0;
    sum = sum * y + 1.0 / 2.0;
    Flight result{seconds, 1.0 - y * (1.0 - y * sum), part * (1.0 - y * sum), part * part * sum};
    for (; doublings > 0; --doublings) {
        result.fall = 2.0 * result.fall + result.reach * result.reach;
        result.reach += result.reach * result.keep;
        result.keep *= result.keep;
    }
    return result;
}

/// Returns the time in seconds after which `reach` has the given value, the inverse of flight().
/// Precondition: 0 <= reach, and air_resistance * reach < 1: further than that nothing gets.
double time_of_reach(double air_resistance, double reach);

} // namespace particles
