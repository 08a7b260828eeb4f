#pragma once

#include <string>

namespace platform {

/// What `tanklab` is asked to do.
struct WindowOptions
{
    std::string link;   ///< A fragment, with or without '#', or a whole address that ends in one.
    std::string assets; ///< The folder of the tank's files; "": the one that comes with the program.
    bool help = false;
};

/// Reads the program's arguments, which begin with its name, into `options`; once in a process.
/// Returns "" or a sentence that names the argument that is wrong.
std::string read_window_options(int count, char* const* arguments, WindowOptions& options);

/// Returns the help text of `tanklab`.
const char* window_usage();

} // namespace platform
