// tanklab-render: draws the state a link describes, without a window.
//
// legacygl and the system's OpenGL define the same symbols, so there is an executable for each, from this
// one source: `tanklab-render` and `tanklab-render-reference`. Whichever is started, the one that --renderer
// asks for does the work.
#include "app/report/state_json.h"
#include "app/simulation/simulation.h"
#include "platform/files/asset_files.h"
#include "platform/files/log_printer.h"
#include "platform/files/png_file.h"
#include "platform/offscreen/offscreen_target.h"
#include "platform/offscreen/render_options.h"
#include "platform/offscreen/threshold_measurement.h"
#include "platform/program/link_argument.h"
#include "platform/program/users_tank_link.h"
#include "scene/drawing/read_pixels.h"
#include "scene/scene_renderer.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

namespace platform {
namespace {

constexpr int BAD_INPUT = 2;

int fail(const std::string& sentence)
{
    std::fprintf(stderr, "tanklab-render: %s\n", sentence.c_str());
    return BAD_INPUT;
}

/// Becomes the executable of the other renderer. Returns only when that cannot be, with the reason.
std::string start_other_renderer(RendererName renderer, char** arguments)
{
    const char* name = renderer == RendererName::reference ? "tanklab-render-reference" : "tanklab-render";
    std::error_code fault;
    const auto other = std::filesystem::read_symlink("/proc/self/exe", fault).replace_filename(name);
    execv(other.c_str(), arguments);
    return "The renderer asked for is in " + other.string() + ", which cannot be started.";
}

/// Draws what the simulation shows and writes the picture, or measures it, or both. Returns "" or what
/// failed.
std::string draw_picture(const RenderOptions& options, const app::Simulation& simulation)
{
    std::string error;
    const std::unique_ptr<OffscreenTarget> target =
        open_offscreen_target(options.width, options.height, error);
    if (target == nullptr) {
        return error;
    }
    scene::SceneRenderer renderer;
    if (error = renderer.load(simulation.assets()); !error.empty()) {
        return error;
    }
    if (!options.out.empty()) {
        renderer.draw(simulation.frame(), options.width, options.height);
        const std::vector<std::uint8_t> rgba = scene::read_pixels(options.width, options.height);
        error = write_png(options.out, options.width, options.height, rgba);
    }
    if (error.empty() && options.measure_threshold) {
        app::Simulation measured = simulation;
        print_threshold(measure_threshold(measured, renderer, options.width, options.height));
    }
    return error;
}

int run(int argument_count, char** arguments)
{
    RenderOptions options;
    if (std::string error = read_render_options(argument_count, arguments, options); !error.empty()) {
        return fail(error + " --help tells more.");
    }
    if (options.help) {
        std::fputs(render_usage(), stdout);
        return 0;
    }
    const bool draws = !options.out.empty() || options.measure_threshold;
    if (draws && options.renderer != offscreen_renderer()) {
        return fail(start_other_renderer(options.renderer, arguments));
    }

    assets::UsersTank tank;
    if (std::string error = read_tank(options.assets, tank); !error.empty()) {
        return fail(error);
    }
    app::Simulation simulation(tank.assets);
    for (const std::string& message : open_link_with(simulation, tank, fragment_of(options.link))) {
        std::fprintf(stderr, "tanklab-render: %s\n", message.c_str());
    }
    if (draws) {
        if (std::string error = draw_picture(options, simulation); !error.empty()) {
            return fail(error);
        }
    }
    if (options.state) {
        std::printf("%s\n", app::state_json(simulation).c_str());
    } else {
        LogPrinter().print(simulation.log());
    }
    return 0;
}

} // namespace
} // namespace platform

int main(int argument_count, char** arguments)
{
    return platform::run(argument_count, arguments);
}
