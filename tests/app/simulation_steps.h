#pragma once

#include "app/simulation/simulation.h"

#include <gtest/gtest.h>
#include <string_view>

namespace app {

/// Opens a link that has nothing wrong with it.
inline void open(Simulation& simulation, std::string_view fragment)
{
    EXPECT_TRUE(simulation.open_link(fragment).messages.empty()) << fragment;
}

/// Goes on by so many ticks.
inline void steps(Simulation& simulation, int count)
{
    for (int i = 0; i < count; ++i) {
        simulation.step();
    }
}

} // namespace app
