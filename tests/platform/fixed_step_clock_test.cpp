#include "platform/program/fixed_step_clock.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using platform::FixedStepClock;

TEST(FixedStepClock, GivesSixtyTicksASecondAtAnyFrameRate)
{
    for (int frames_per_second : {24, 30, 59, 60, 61, 75, 144, 240, 1000}) {
        FixedStepClock clock(60);
        int ticks = 0;
        for (int frame = 0; frame < 10 * frames_per_second; ++frame) {
            ticks += clock.ticks_after(1.0 / frames_per_second);
        }
        EXPECT_NEAR(ticks, 600, 1) << frames_per_second;
    }
}

TEST(FixedStepClock, KeepsWhatIsLeftOfATick)
{
    FixedStepClock clock(60);
    EXPECT_EQ(clock.ticks_after(0.75 / 60.0), 0);
    EXPECT_EQ(clock.ticks_after(0.75 / 60.0), 1);
    EXPECT_EQ(clock.ticks_after(0.75 / 60.0), 1);
    EXPECT_EQ(clock.ticks_after(0.5 / 60.0), 0);
}

TEST(FixedStepClock, CutsALongPauseToAQuarterSecond)
{
    FixedStepClock clock(60);
    EXPECT_EQ(clock.ticks_after(3600.0), 15);
    EXPECT_EQ(clock.ticks_after(std::numeric_limits<double>::infinity()), 15);
}

TEST(FixedStepClock, CountsTimeThatIsNoneAsNone)
{
    FixedStepClock clock(60);
    EXPECT_EQ(clock.ticks_after(-1.0), 0);
    EXPECT_EQ(clock.ticks_after(std::nan("")), 0);
    EXPECT_EQ(clock.ticks_after(1.5 / 60.0), 1);
}

} // namespace
