// Runs the check of a task on a program with a fault in it: mutant_ID TASK FAULT. The check has to fail; the
// exit status is 0 then. With no fault given it has to pass.
#include "checks/checks.h"
#include "platform/files/asset_files.h"
#include "platform/offscreen/offscreen_target.h"
#include "scene/scene_renderer.h"

#include <cstdio>
#include <memory>
#include <string>

int main(int argument_count, char** arguments)
{
    if (argument_count < 2) {
        std::fputs("usage: mutant_ID TASK [FAULT]\n", stderr);
        return 2;
    }
    constexpr int SIDE = 256; // pixels
    const bool is_faulty = argument_count > 2;
    std::string error;
    const std::unique_ptr<platform::OffscreenTarget> target =
        platform::open_offscreen_target(SIDE, SIDE, error);
    assets::Assets assets;
    if (error.empty()) {
        error = platform::read_asset_folder(ASSETS, assets);
    }
    scene::SceneRenderer renderer;
    if (error.empty()) {
        error = renderer.load(assets);
    }
    if (!error.empty()) {
        std::fprintf(stderr, "%s\n", error.c_str());
        return 2;
    }
    const auto result = checks::run_check(arguments[1], {assets, renderer, SIDE, SIDE});
    if (!result) {
        std::fprintf(stderr, "Task %s has no check.\n", arguments[1]);
        return 2;
    }
    std::printf("%s\nThe check of task %s %s:\n", is_faulty ? arguments[2] : "No fault.", arguments[1],
                result->passed ? "passed" : "failed");
    for (const std::string& sentence : result->evidence) {
        std::printf("  %s\n", sentence.c_str());
    }
    return result->passed == is_faulty ? 1 : 0;
}
