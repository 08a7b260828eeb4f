#include "platform/web/web_canvas.h"

#include "app/commands/commands.h"
#include "app/commands/keys.h"

#include <algorithm>
#include <cmath>

#include <emscripten.h>
#include <emscripten/html5.h>

namespace platform {
namespace {

constexpr const char* CANVAS = "#canvas";

// Lets only keys that do something here, and no browser shortcuts, through to SDL, which takes every key it
// sees away from the browser: Tab would be caught in the canvas, Ctrl+R would not reload.
// A click on the canvas focuses it, which SDL's own handler prevents.
// clang-format off
EM_JS(void, prepare_canvas_input, (const char* used_codes), {
    const used = new Set(UTF8ToString(used_codes).split(" "));
    const canvas = document.querySelector("#canvas");
    if (!canvas.hasAttribute("tabindex")) {
        canvas.tabIndex = 0;
    }
    canvas.addEventListener("keydown", (event) => {
        if (!used.has(event.code) || event.ctrlKey || event.altKey || event.metaKey) {
            event.stopImmediatePropagation();
        }
    }, true);
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
});
// clang-format on

std::string used_key_codes()
{
    std::string codes;
    for (const app::Command& command : app::commands()) {
        for (app::Key key : command.keys) {
            if (key != app::Key::none) {
                codes += (codes.empty() ? "" : " ") + std::string(app::key_code(key));
            }
        }
    }
    return codes;
}

/// Keys that come up while something else has the focus are never reported: let go of all.
EM_BOOL on_blur(int, const EmscriptenFocusEvent*, void*)
{
    SDL_ResetKeyboard();
    return EM_FALSE;
}

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE make_webgl_context(bool antialias)
{
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = EM_FALSE; // or the page's background would shine through
    attributes.depth = EM_TRUE;
    attributes.stencil = EM_TRUE;
    attributes.antialias = antialias ? EM_TRUE : EM_FALSE;
    attributes.preserveDrawingBuffer = EM_FALSE;
    attributes.enableExtensionsByDefault = EM_TRUE;
    return emscripten_webgl_create_context(CANVAS, &attributes);
}

} // namespace

struct WebCanvas::Handlers
{
    static EM_BOOL lost(int, const void*, void* canvas)
    {
        auto* self = static_cast<WebCanvas*>(canvas);
        self->lost_ = true;
        legacygl_context_lost(self->legacygl_);
        return EM_TRUE; // prevents the default, which is never to give it back
    }

    static EM_BOOL restored(int, const void*, void* canvas)
    {
        auto* self = static_cast<WebCanvas*>(canvas);
        self->lost_ = false;
        self->restored_ = true;
        legacygl_context_restored(self->legacygl_);
        return EM_TRUE;
    }
};

std::string WebCanvas::open(bool antialias)
{
    SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, CANVAS);
    prepare_canvas_input(used_key_codes().c_str()); // before SDL, so that it hears of keys first
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        return std::string("The page cannot take input: ") + SDL_GetError();
    }
    window_ = SDL_CreateWindow("Tank Lab", 0, 0, 1, 1, SDL_WINDOW_ALLOW_HIGHDPI);
    if (window_ == nullptr) {
        return std::string("The page cannot take input: ") + SDL_GetError();
    }
    SDL_StopTextInput(); // keys are commands here; SDL then keeps them from scrolling the page

    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE webgl = make_webgl_context(antialias);
    if (webgl <= 0 || emscripten_webgl_make_context_current(webgl) != EMSCRIPTEN_RESULT_SUCCESS) {
        return "This browser gives the page no WebGL 2, which drawing the tank needs.";
    }
    fit();
    legacygl_ = legacygl_create(nullptr, width_, height_, LEGACYGL_TARGET_WINDOW);
    if (legacygl_ == nullptr) {
        return std::string("legacygl cannot draw here: ") + legacygl_last_message();
    }
    emscripten_set_blur_callback(CANVAS, nullptr, EM_FALSE, on_blur);
    emscripten_set_webglcontextlost_callback(CANVAS, this, EM_FALSE, Handlers::lost);
    emscripten_set_webglcontextrestored_callback(CANVAS, this, EM_FALSE, Handlers::restored);
    return "";
}

bool WebCanvas::fit()
{
    double css_width = 0.0;
    double css_height = 0.0;
    emscripten_get_element_css_size(CANVAS, &css_width, &css_height);
    const double ratio = emscripten_get_device_pixel_ratio();
    const int width = std::max(1, static_cast<int>(std::lround(css_width * ratio)));
    const int height = std::max(1, static_cast<int>(std::lround(css_height * ratio)));
    if (width == width_ && height == height_) {
        return false;
    }
    width_ = width;
    height_ = height;
    // SDL counts the mouse's way in these; it also sets the canvas, by its own rounding, so ours comes after.
    SDL_SetWindowSize(window_, std::max(1, static_cast<int>(std::lround(css_width))),
                      std::max(1, static_cast<int>(std::lround(css_height))));
    emscripten_set_canvas_element_size(CANVAS, width, height);
    if (legacygl_ != nullptr) {
        legacygl_resize(legacygl_, width, height);
    }
    return true;
}

WindowSize WebCanvas::size_in_points() const
{
    WindowSize size{1, 1};
    SDL_GetWindowSize(window_, &size.width, &size.height);
    return size;
}

bool WebCanvas::take_restored()
{
    const bool restored = restored_;
    restored_ = false;
    return restored;
}

} // namespace platform
