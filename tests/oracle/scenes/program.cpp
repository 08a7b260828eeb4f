#include "scenes/program.h"

#include "app/simulation/simulation.h"
#include "platform/files/asset_files.h"
#include "scene/scene_renderer.h"

#include <cstdio>
#include <cstdlib>
#include <map>

namespace oracle {
namespace {

const assets::Assets& assets()
{
    static const assets::Assets all = [] {
        assets::Assets read;
        const std::string error = platform::read_asset_folder(ORACLE_ASSETS, read);
        if (!error.empty()) {
            std::fprintf(stderr, "%s\n", error.c_str());
            std::abort();
        }
        return read;
    }();
    return all;
}

} // namespace

void draw_link(const std::string& link)
{
    app::Simulation simulation(assets());
    for (const std::string& message : simulation.open_link(link).messages) {
        tell(message);
    }
    scene::SceneRenderer renderer;
    tell(renderer.load(assets()));
    renderer.draw(simulation.frame(), PROGRAM_SIZE.width, PROGRAM_SIZE.height);
}

void add_link(const std::string& name, const std::string& link)
{
    static const std::map<std::string, int> ties_in_26 = {
        {"shadow_wires", 13}, {"program_edges_of_both", 8}, {"figure_6", 2},
        {"task_1_4", 1},      {"tank_front_turned", 1},     {"tank_side_low_rest", 1},
        {"view_follow", 1},   {"tank_side_low_turned", 1},  {"tank_far_above_back", 1},
    };
    const auto ties = ties_in_26.find(name);
    const int pixels = ties == ties_in_26.end() ? 0 : ties->second;
    scenes().push_back({name, [link] { draw_link(link); }, {pixels, LAST_BIT_DECIDES, {26}}, PROGRAM_SIZE});
}

} // namespace oracle
