#pragma once

#include "app/simulation/simulation.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Holds one thing that can be read off the running program, for people.
struct Fact
{
    std::string_view label;
    std::string value;
};

/// Returns what shows live that the state's task is done: for tasks and figures about spheres and the
/// projectile what is tested and penetrated, for those about levels distances and triangles, and so on.
/// Of a tank that the user brought, by which factor it is scaled.
/// Without a task: the level, the triangles drawn and, if something is tested, what is penetrated.
std::vector<Fact> facts(const Simulation& simulation);

/// Returns the number of triangles of the tanks that are drawn.
std::size_t triangles_drawn(const Simulation& simulation);

} // namespace app
