#pragma once

#include "assets/assets.h"
#include "checks/checks.h"
#include "platform/program/program.h"
#include "platform/web/web_canvas.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace platform {

/// The program in a page. The page brings the files, starts it, and is told when the state changes; how the
/// two call each other stands in web_bridge.cpp.
class WebPage
{
public:
    /// Keeps a file until start() or bring_tank() reads it. A file of the same name is replaced.
    void add_file(std::string_view name, std::span<const std::uint8_t> bytes);

    /// Reads the files, opens the canvas and the link, and begins to run.
    /// Returns "" or a sentence that says what is wrong; start() may be called again then, with better files.
    std::string start(std::string_view fragment);

    void forget_files() { files_.clear(); }

    /// Reads a tank that the user brought from the files added since the start, and shows it, keeping the
    /// rest of the state. Returns {`error`, `notes`} as JSON: "" or a sentence that says what is wrong, and
    /// nothing has changed then; and what people should know of the tank, a sentence each. The files are
    /// forgotten.
    std::string bring_tank();

    Program& program() { return program_; }

    /// Draws one frame and returns the GL calls it made as JSON. Vertices within lists are counted, not
    /// listed.
    std::string capture();

    /// Runs the check of a task, if it has one, and remembers what it found.
    void check(std::string_view id);

    /// Returns what the last checks of the tasks found.
    const checks::CheckResults& check_results() const { return check_results_; }

    /// Draws the current state now, within the caller's own task, whether it changed or not.
    void draw_now();

    /// Returns how many draw calls the last picture took.
    std::uint64_t draw_calls() const { return draw_calls_; }

private:
    void frame();
    void draw();
    void report();
    std::vector<assets::AssetFile> views_of_files() const;

    struct File
    {
        std::string name;
        std::vector<std::uint8_t> bytes;
    };

    std::vector<File> files_; // names differ, with their folders
    checks::CheckResults check_results_;
    WebCanvas canvas_;
    Program program_;
    bool canvas_open_ = false;
    double last_frame_seconds_ = 0.0;
    std::uint64_t draw_calls_ = 0;
    bool reported_ = false;
    std::uint64_t reported_revision_ = 0;
};

} // namespace platform
