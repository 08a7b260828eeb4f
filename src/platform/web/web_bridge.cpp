// What the page calls, as C functions of the WebAssembly module. Texts are UTF-8; a text that is returned is
// valid until the next call. What the program calls in the page stands in web_page.cpp.
#include "app/links/links.h"
#include "app/report/state_json.h"
#include "app/report/tables_json.h"
#include "checks/check_json.h"
#include "platform/web/web_page.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <emscripten.h>

namespace {

platform::WebPage& page()
{
    static platform::WebPage the_page;
    return the_page;
}

platform::Program& program()
{
    return page().program();
}

const char* kept(std::string text)
{
    static std::string last;
    last = std::move(text);
    return last.c_str();
}

constexpr const char* NOT_STARTED = "The program has not started.";

} // namespace

extern "C" {

/// Gives a file to the program, by its name and bytes, for tanklab_start or tanklab_bring_tank.
EMSCRIPTEN_KEEPALIVE void tanklab_add_file(const char* name, const std::uint8_t* data, std::size_t size)
{
    page().add_file(name, {data, size});
}

/// Starts the program in the state of a fragment. Returns "" or a sentence that says what is wrong.
EMSCRIPTEN_KEEPALIVE const char* tanklab_start(const char* fragment)
{
    return kept(page().start(fragment));
}

/// Returns which files make a tank, and how large they may be, as JSON (app::asset_manifest_json).
EMSCRIPTEN_KEEPALIVE const char* tanklab_asset_manifest()
{
    return kept(app::asset_manifest_json());
}

/// Forgets the files added since the start, where not all of them could be.
EMSCRIPTEN_KEEPALIVE void tanklab_forget_files()
{
    page().forget_files();
}

/// Reads the files added since as the user's own tank and shows it. Returns what came of it as JSON
/// (platform::WebPage::bring_tank).
EMSCRIPTEN_KEEPALIVE const char* tanklab_bring_tank()
{
    return kept(program().started() ? page().bring_tank() : app::tank_brought_json(NOT_STARTED, {}));
}

/// Returns the state as JSON (app::state_json); before the start that of an empty link.
EMSCRIPTEN_KEEPALIVE const char* tanklab_state()
{
    return kept(program().started() ? app::state_json(program().simulation())
                                    : app::state_json(app::State{}, nullptr));
}

/// Returns the fields as JSON (app::fields_json), or null before the start.
EMSCRIPTEN_KEEPALIVE const char* tanklab_fields()
{
    return kept(program().started() ? app::fields_json(program().state()) : "null");
}

/// Returns what shows that the task is done as JSON (app::evidence_json), or null before the start.
EMSCRIPTEN_KEEPALIVE const char* tanklab_evidence()
{
    return kept(program().started() ? app::evidence_json(program().simulation()) : "null");
}

/// Returns the report of hits as JSON (app::report_json), or null before the start.
EMSCRIPTEN_KEEPALIVE const char* tanklab_report()
{
    return kept(program().started() ? app::report_json(program().simulation()) : "null");
}

/// Returns what the probe hits as JSON (app::hits_json), or null before the start.
EMSCRIPTEN_KEEPALIVE const char* tanklab_hits()
{
    return kept(program().started() ? app::hits_json(program().simulation()) : "null");
}

/// Returns the table of commands as JSON (app::commands_json).
EMSCRIPTEN_KEEPALIVE const char* tanklab_commands()
{
    return kept(app::commands_json());
}

/// Executes a command. Returns "" or a sentence that says why nothing was done.
EMSCRIPTEN_KEEPALIVE const char* tanklab_command(const char* name, double value)
{
    return kept(program().started() ? program().command(name, value) : NOT_STARTED);
}

/// Returns the fragment that describes the state, without '#'; "" before the start.
EMSCRIPTEN_KEEPALIVE const char* tanklab_link()
{
    return kept(program().started() ? app::link(program().state()) : "");
}

/// Opens a fragment. Returns the messages about it as a JSON array of sentences.
EMSCRIPTEN_KEEPALIVE const char* tanklab_open_link(const char* fragment)
{
    if (!program().started()) {
        const std::string messages[] = {NOT_STARTED};
        return kept(app::strings_json(messages));
    }
    return kept(app::strings_json(program().open_link(fragment)));
}

/// Draws a frame and returns the GL calls it made (capture_json).
EMSCRIPTEN_KEEPALIVE const char* tanklab_capture()
{
    return kept(program().started() ? page().capture() : "[]");
}

/// Returns how many draw calls the last picture took.
EMSCRIPTEN_KEEPALIVE double tanklab_draw_calls()
{
    return static_cast<double>(page().draw_calls());
}

/// Returns the lab's tasks and figures, with what their last checks found (tasks_json).
EMSCRIPTEN_KEEPALIVE const char* tanklab_tasks()
{
    return kept(checks::tasks_json(page().check_results()));
}

/// Runs the check of a task, if it has one, and returns the task or figure with what it found (task_json).
EMSCRIPTEN_KEEPALIVE const char* tanklab_check(const char* id)
{
    if (program().started()) {
        page().check(id);
    }
    return kept(checks::task_json(id, page().check_results()));
}

/// Draws the state at once, so that the canvas can be read within the same task of the page.
EMSCRIPTEN_KEEPALIVE void tanklab_draw()
{
    if (program().started()) {
        page().draw_now();
    }
}

} // extern "C"

/// The page starts the program by tanklab_start; the module stays alive when main returns.
int main()
{
    return 0;
}
