#include "particles/flight.h"

#include <cmath>
#include <gtest/gtest.h>

namespace particles {
namespace {

constexpr double TINY = 4e-15; // a few roundings

TEST(Flight, WithoutAirIsTheParabola)
{
    for (const double t : {0.0, 1e-9, 1.0 / 60.0, 0.5, 3.0, 60.0}) {
        const Flight f = flight(0.0, t);
        EXPECT_EQ(f.seconds, t);
        EXPECT_EQ(f.keep, 1.0);
        EXPECT_EQ(f.reach, t);
        EXPECT_EQ(f.fall, t * t / 2.0);
    }
}

TEST(Flight, WithAirIsTheSolutionOfTheEquationOfMotion)
{
    for (const double k : {1e-6, 0.01, 0.3, 1.5, 4.0, 30.0, 1000.0}) {
        for (const double t : {1e-5, 1.0 / 60.0, 0.1, 0.7, 2.0, 60.0}) {
            const Flight f = flight(k, t);
            const double y = k * t;
            const double reach = -std::expm1(-y) / k;
            EXPECT_NEAR(f.keep, std::exp(-y), TINY) << k << " " << t;
            EXPECT_NEAR(f.reach, reach, TINY * reach) << k << " " << t;
            if (y > 0.1) { // below, this formula has too few digits itself
                const double fall = (t - reach) / k;
                EXPECT_NEAR(f.fall, fall, 2e-13 * fall) << k << " " << t;
            } else {
                const double series = t * t * (0.5 - y / 6.0 + y * y / 24.0 - y * y * y / 120.0);
                EXPECT_NEAR(f.fall, series, (TINY + y * y * y * y / 720.0 * 2.2) * series) << k << " " << t;
            }
        }
    }
}

TEST(Flight, HasNoJumpWhereDoublingBegins)
{
    for (int doublings = 0; doublings < 12; ++doublings) {
        const double t = std::ldexp(1.0 / 32.0, doublings);
        const Flight below = flight(1.0, t);
        const Flight above = flight(1.0, std::nextafter(t, 100.0));
        EXPECT_NEAR(below.keep, above.keep, TINY * below.keep * t * 100.0);
        EXPECT_NEAR(below.reach, above.reach, TINY * below.reach * 100.0);
        EXPECT_NEAR(below.fall, above.fall, TINY * below.fall * 100.0);
    }
}

TEST(Flight, OfTwoTimesInARowIsTheFlightOfTheirSum)
{
    const double k = 0.8;
    const Flight first = flight(k, 0.3);
    const Flight second = flight(k, 0.5);
    const Flight both = flight(k, 0.8);
    EXPECT_NEAR(first.keep * second.keep, both.keep, TINY);
    EXPECT_NEAR(first.reach + first.keep * second.reach, both.reach, TINY);
    EXPECT_NEAR(first.fall + first.reach * second.reach + second.fall, both.fall, TINY);
}

TEST(Flight, OfHugeTimesAndResistancesIsFinite)
{
    for (const double k : {0.0, 5e-324, 1e-300, 1.0, 1000.0}) {
        for (const double t : {0.0, 5e-324, 1e-300, 60.0, 1e100}) {
            const Flight f = flight(k, t);
            EXPECT_TRUE(f.keep >= 0.0 && f.keep <= 1.0) << k << " " << t;
            EXPECT_TRUE(f.reach >= 0.0 && f.reach <= t) << k << " " << t;
            EXPECT_TRUE(std::isfinite(f.fall) && f.fall >= 0.0) << k << " " << t;
        }
    }
}

TEST(TimeOfReach, IsTheInverseOfReach)
{
    for (const double k : {0.0, 1e-3, 0.7, 5.0, 1000.0}) {
        for (const double t : {0.0, 1e-6, 1.0 / 60.0, 0.9, 5.0}) {
            if (k * t < 20.0) { // later, hardly anything of the way is left
                const double error = 1e-14 * std::exp(k * t);
                EXPECT_NEAR(time_of_reach(k, flight(k, t).reach), t, error * (t + 1e-3)) << k << " " << t;
            }
        }
    }
}

TEST(TimeOfReach, IsFiniteForTheLastBitOfTheWay)
{
    const double time = time_of_reach(2.0, std::nextafter(0.5, 0.0));
    EXPECT_GT(time, 10.0);
    EXPECT_LT(time, 100.0);
    EXPECT_LT(time_of_reach(2.0, std::nextafter(0.5, 1.0)), 100.0) << "rounding may ask for a bit too far";
}

} // namespace
} // namespace particles
