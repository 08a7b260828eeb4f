#include "platform/web/web_page.h"

#include "app/report/state_json.h"
#include "app/report/tables_json.h"
#include "app/view/camera_view.h"
#include "assets/users_tank.h"
#include "checks/capture_json.h"

#include <algorithm>
#include <utility>

#include <SDL.h>
#include <emscripten.h>
#include <emscripten/html5.h>
#include <legacygl/legacygl.h>

namespace platform {
namespace {

// clang-format off
EM_JS(void, tell_status, (const char* json), {
    if (Module["onStatus"]) {
        Module["onStatus"](UTF8ToString(json));
    }
});

EM_JS(void, tell_message, (const char* text), {
    if (Module["onMessage"]) {
        Module["onMessage"](UTF8ToString(text));
    }
});

// ?antialias=0 in the page's address: for pictures that are compared.
EM_JS(int, wants_antialias, (), {
    return new URLSearchParams(location.search).get("antialias") === "0" ? 0 : 1;
});
// clang-format on

/// A check draws hundreds of pictures: large enough to judge, small enough not to keep anybody waiting.
/// Pixels.
constexpr int CHECK_WIDTH = 480;
constexpr int CHECK_HEIGHT = 300;

double seconds_now()
{
    return emscripten_get_now() / 1000.0;
}

} // namespace

void WebPage::add_file(std::string_view name, std::span<const std::uint8_t> bytes)
{
    const auto place =
        std::find_if(files_.begin(), files_.end(), [name](const File& file) { return file.name == name; });
    File& file = place == files_.end() ? files_.emplace_back() : *place;
    file.name = name;
    file.bytes.assign(bytes.begin(), bytes.end());
}

std::string WebPage::start(std::string_view fragment)
{
    if (program_.started()) {
        return "The program runs already.";
    }
    base::Result<assets::Assets> assets = assets::read_assets(views_of_files(), app::paint_view());
    if (!assets) {
        return assets.error().message();
    }
    if (!canvas_open_) {
        if (std::string error = canvas_.open(wants_antialias() != 0); !error.empty()) {
            return error;
        }
        canvas_open_ = true;
    }
    if (std::string error = program_.start(std::move(assets).value()); !error.empty()) {
        return error;
    }
    files_.clear();
    for (const std::string& message : program_.open_link(fragment)) {
        tell_message(message.c_str());
    }
    draw_now();
    report();
    last_frame_seconds_ = seconds_now();
    const auto run_frame = [](double,
                              void* page) -> EM_BOOL { // which is int or bool, by Emscripten's version
        static_cast<WebPage*>(page)->frame();
        return EM_TRUE; // and again
    };
    emscripten_request_animation_frame_loop(run_frame, this); // at the display's own rate
    return "";
}

std::vector<assets::AssetFile> WebPage::views_of_files() const
{
    std::vector<assets::AssetFile> files;
    for (const File& file : files_) {
        files.push_back({file.name, file.bytes});
    }
    return files;
}

std::string WebPage::bring_tank()
{
    base::Result<assets::UsersTank> tank = assets::read_users_tank(views_of_files(), app::paint_view());
    files_.clear();
    if (!tank) {
        return app::tank_brought_json(tank.error().message(), {});
    }
    const std::vector<std::string> notes = std::move(tank.value().notes);
    const std::string fault = program_.set_user_tank(std::move(tank.value().assets));
    if (fault.empty()) {
        draw();
        report();
    }
    return app::tank_brought_json(fault, notes);
}

void WebPage::frame()
{
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
        program_.handle(event, canvas_.size_in_points());
    }
    const double now = seconds_now();
    program_.advance(now - last_frame_seconds_);
    last_frame_seconds_ = now;

    canvas_.fit();
    if (canvas_.take_restored()) {
        program_.redraw();
    }
    draw();
    report();
}

void WebPage::draw()
{
    if (canvas_.lost()) {
        return;
    }
    legacygl_reset_counters(legacygl_current());
    if (program_.draw_if_changed(canvas_.width(), canvas_.height())) {
        legacygl_present(legacygl_current());
        draw_calls_ = legacygl_counters(legacygl_current()).draw_calls;
    }
}

void WebPage::report()
{
    const std::uint64_t revision = program_.simulation().revision();
    if (reported_ && reported_revision_ == revision) {
        return;
    }
    reported_ = true;
    reported_revision_ = revision;
    tell_status(app::status_json(program_.simulation()).c_str());
}

void WebPage::draw_now()
{
    program_.redraw();
    draw();
}

std::string WebPage::capture()
{
    legacygl_capture_begin(legacygl_current());
    draw_now();
    std::size_t count = 0;
    const LegacyGLCall* calls = legacygl_capture_end(legacygl_current(), &count);
    return checks::capture_json({calls, count});
}

void WebPage::check(std::string_view id)
{
    const checks::CheckSubject subject{program_.assets(), program_.renderer(),
                                       std::min(canvas_.width(), CHECK_WIDTH),
                                       std::min(canvas_.height(), CHECK_HEIGHT)};
    if (std::optional<checks::CheckResult> result = checks::run_check(id, subject)) {
        checks::remember(check_results_, *std::move(result));
        draw_now(); // the check drew over the picture
    }
}

} // namespace platform
