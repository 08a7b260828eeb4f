#pragma once

#include "app/simulation/simulation.h"
#include "assets/users_tank.h"

#include <string>
#include <string_view>
#include <vector>

namespace platform {

/// Opens a fragment in a simulation of a tank that a folder was named for, and says what people should know:
/// of the tank and of the link, a sentence each. A tank that is not ours is the state's own one, asked for by
/// the link or not, so that a link of that state says so.
std::vector<std::string> open_link_with(app::Simulation& simulation, const assets::UsersTank& tank,
                                        std::string_view fragment);

} // namespace platform
