// tanklab: the program in a desktop window, drawn through legacygl on OpenGL ES 3.
#include "app/links/links.h"
#include "platform/desktop/window_options.h"
#include "platform/files/asset_files.h"
#include "platform/files/log_printer.h"
#include "platform/program/link_argument.h"
#include "platform/program/program.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include <SDL.h>
#include <legacygl/legacygl.h>

namespace platform {
namespace {

constexpr int BAD_INPUT = 2;

/// The title follows the state, but not so fast that window managers cannot.
constexpr double SECONDS_BETWEEN_TITLES = 0.25;

int fail(const std::string& sentence)
{
    std::fprintf(stderr, "tanklab: %s\n", sentence.c_str());
    return BAD_INPUT;
}

/// The SDL window and the two contexts in it. Closes what it opened.
class Window
{
public:
    Window() = default;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    ~Window()
    {
        legacygl_destroy(legacygl_);
        if (es_ != nullptr) {
            SDL_GL_DeleteContext(es_);
        }
        if (window_ != nullptr) {
            SDL_DestroyWindow(window_);
        }
        SDL_Quit();
    }

    /// Opens the window. Returns "" or what failed.
    std::string open()
    {
        if (SDL_Init(SDL_INIT_VIDEO) != 0) {
            return std::string("There is no display to open a window on: ") + SDL_GetError();
        }
        // Without a display SDL falls back to a window that nobody sees; only who asks for that gets it.
        if (std::string_view(SDL_GetCurrentVideoDriver()) == "offscreen" &&
            SDL_getenv("SDL_VIDEODRIVER") == nullptr) {
            return "There is no display to open a window on. tanklab-render draws without one.";
        }
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
        SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
        SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 8);
        SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, 1);
        SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, 4);
        if (!open_window()) {
            SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, 0); // not every driver can smooth edges
            SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, 0);
            if (!open_window()) {
                return std::string("No window with OpenGL ES 3 can be opened: ") + SDL_GetError();
            }
        }
        SDL_GL_SetSwapInterval(1);
        measure();
        legacygl_ = legacygl_create(SDL_GL_GetProcAddress, width_, height_, LEGACYGL_TARGET_WINDOW);
        if (legacygl_ == nullptr) {
            return std::string("legacygl cannot draw here: ") + legacygl_last_message();
        }
        return "";
    }

    /// Asks for the size again, in pixels: it is not that of the events where pixels are small.
    void measure()
    {
        SDL_GL_GetDrawableSize(window_, &width_, &height_);
        if (legacygl_ != nullptr && width_ > 0 && height_ > 0) {
            legacygl_resize(legacygl_, width_, height_);
        }
    }

    /// Returns the size that the mouse's events are counted in.
    WindowSize size_in_points() const
    {
        WindowSize size{1, 1};
        SDL_GetWindowSize(window_, &size.width, &size.height);
        return size;
    }

    bool has_area() const { return width_ > 0 && height_ > 0; }
    int width() const { return width_; }
    int height() const { return height_; }
    void set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }

    void present()
    {
        legacygl_present(legacygl_);
        SDL_GL_SwapWindow(window_);
    }

private:
    bool open_window()
    {
        constexpr Uint32 FLAGS = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
        window_ =
            SDL_CreateWindow("Tank Lab", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 1280, 800, FLAGS);
        if (window_ == nullptr) {
            return false;
        }
        es_ = SDL_GL_CreateContext(window_);
        if (es_ == nullptr) {
            SDL_DestroyWindow(window_);
            window_ = nullptr;
        }
        return es_ != nullptr;
    }

    SDL_Window* window_ = nullptr;
    SDL_GLContext es_ = nullptr;
    LegacyGLContext* legacygl_ = nullptr;
    int width_ = 0;  // pixels
    int height_ = 0; // pixels
};

/// Shows the link of the state in the window's title.
class Title
{
public:
    void update(Window& window, const app::Simulation& simulation, double now)
    {
        if (now < next_at_ || (shown_ && shown_revision_ == simulation.revision())) {
            return;
        }
        const std::string link = app::link(simulation.state());
        window.set_title(link.empty() ? "Tank Lab" : "Tank Lab  #" + link);
        shown_ = true;
        shown_revision_ = simulation.revision();
        next_at_ = now + SECONDS_BETWEEN_TITLES;
    }

private:
    bool shown_ = false;
    std::uint64_t shown_revision_ = 0;
    double next_at_ = 0.0;
};

double seconds_now()
{
    return static_cast<double>(SDL_GetPerformanceCounter()) /
           static_cast<double>(SDL_GetPerformanceFrequency());
}

/// Takes all events that are waiting. Returns false when the window is closed.
bool take_events(Program& program, Window& window)
{
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
        if (event.type == SDL_QUIT) {
            return false;
        }
        if (event.type == SDL_WINDOWEVENT) {
            if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
                window.measure();
            } else if (event.window.event == SDL_WINDOWEVENT_EXPOSED) {
                program.redraw();
            }
        }
        program.handle(event, window.size_in_points());
    }
    return true;
}

void run_until_closed(Program& program, Window& window)
{
    constexpr int IDLE_MILLISECONDS = 8; // less than a tick, so that held keys stay smooth
    Title title;
    LogPrinter printer;
    double last = seconds_now();
    while (take_events(program, window)) {
        const double now = seconds_now();
        program.advance(now - last);
        last = now;
        printer.print(program.simulation().log());
        title.update(window, program.simulation(), now);
        if (window.has_area() && program.draw_if_changed(window.width(), window.height())) {
            window.present();
        } else {
            SDL_WaitEventTimeout(nullptr, IDLE_MILLISECONDS);
        }
    }
}

int run(int argument_count, char** arguments)
{
    WindowOptions options;
    if (std::string error = read_window_options(argument_count, arguments, options); !error.empty()) {
        return fail(error + " --help tells more.");
    }
    if (options.help) {
        std::fputs(window_usage(), stdout);
        return 0;
    }
    assets::UsersTank tank;
    if (std::string error = read_tank(options.assets, tank); !error.empty()) {
        return fail(error);
    }
    Window window;
    if (std::string error = window.open(); !error.empty()) {
        return fail(error);
    }
    Program program;
    if (std::string error = program.start(tank.assets); !error.empty()) {
        return fail(error);
    }
    for (const std::string& message : program.open_link_with(tank, fragment_of(options.link))) {
        std::fprintf(stderr, "tanklab: %s\n", message.c_str());
    }
    run_until_closed(program, window);
    return 0;
}

} // namespace
} // namespace platform

int main(int argument_count, char** arguments)
{
    return platform::run(argument_count, arguments);
}
