// The program's own picture: the assembled tank from four cameras in three poses, as a link describes them.

#include "app/frame.h"
#include "app/links.h"
#include "platform/asset_files.h"
#include "scene/scene_renderer.h"
#include "scenes/common.h"

#include <cstdio>
#include <cstdlib>

namespace {

constexpr oracle::Size SIZE = {640, 400};

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

void draw(const std::string& link)
{
    app::State state;
    for (const std::string& message : app::open_link(state, link).messages)
        oracle::tell(message);
    scene::SceneRenderer renderer;
    oracle::tell(renderer.load(assets()));
    renderer.draw(app::make_frame(state, assets()), SIZE.width, SIZE.height);
}

struct Named
{
    const char* name;
    const char* link;
};

constexpr Named CAMERAS[] = {{"front", "orbit=40&tilt=15&distance=11.5"},
                             {"rear", "orbit=-150&tilt=25&distance=13"},
                             {"side_low", "orbit=90&tilt=3&distance=9"},
                             {"far_above", "orbit=10&tilt=70&distance=45"}};
constexpr Named POSES[] = {{"rest", ""},
                           {"turned", "turret=60&gun=20&secondary_gun=45&wheels_left=20&wheels_right=-50"},
                           {"back", "turret=-165&gun=-9&secondary_gun=-120&heading=30&x=1.5&z=-2"}};

[[maybe_unused]] const bool registered = [] {
    for (const Named& camera : CAMERAS)
        for (const Named& pose : POSES) {
            const std::string link = std::string(camera.link) + "&" + pose.link;
            oracle::scenes().push_back(
                {std::string("tank_") + camera.name + "_" + pose.name, [link] { draw(link); }, {}, SIZE});
        }
    return true;
}();

} // namespace
