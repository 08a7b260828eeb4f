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
Flight flight(double air_resistance, double seconds);

/// Returns the time in seconds after which `reach` has the given value, the inverse of flight().
/// Precondition: 0 <= reach, and air_resistance * reach < 1: further than that nothing gets.
double time_of_reach(double air_resistance, double reach);

} // namespace particles
