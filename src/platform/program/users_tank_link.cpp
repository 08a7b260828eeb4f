#include "platform/program/users_tank_link.h"

namespace platform {

std::vector<std::string> open_link_with(app::Simulation& simulation, const assets::UsersTank& tank,
                                        std::string_view fragment)
{
    const bool is_own = tank.data != assets::TankData::ours;
    if (is_own) {
        simulation.set_user_tank(&simulation.assets());
    }
    std::vector<std::string> messages = tank.notes;
    const std::vector<std::string> of_link = simulation.open_link(fragment).messages;
    messages.insert(messages.end(), of_link.begin(), of_link.end());
    if (is_own && simulation.state().tank != app::TankShown::own) {
        simulation.open_link(std::string(fragment) + "&tank=own");
    }
    if (simulation.lacks_own_tank()) {
        messages.emplace_back("The link is about a tank of the user's own: name the folder of its files with "
                              "--assets. The program's own is shown in its place.");
    }
    return messages;
}

} // namespace platform
