#include "scenes/program.h"

#include "app/simulation.h"
#include "platform/asset_files.h"
#include "scene/scene_renderer.h"

#include <cstdio>
#include <cstdlib>

namespace oracle {
namespace {

const app::Assets& assets()
{
    static const app::Assets all = [] {
        app::Assets read;
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
    for (const std::string& message : simulation.open_link(link).messages)
        tell(message);
    scene::SceneRenderer renderer;
    tell(renderer.load(assets()));
    renderer.draw(simulation.frame(), PROGRAM_SIZE.width, PROGRAM_SIZE.height);
}

void add_link(const std::string& name, const std::string& link, const Exception& exception)
{
    scenes().push_back({name, [link] { draw_link(link); }, exception, PROGRAM_SIZE});
}

} // namespace oracle
