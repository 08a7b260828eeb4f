#include "platform/desktop/window_options.h"

#include <string_view>

namespace platform {

std::string read_window_options(std::span<const char* const> arguments, WindowOptions& options)
{
    bool have_link = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--help") {
            options.help = true;
            return "";
        }
        if (argument == "--assets") {
            if (i + 1 == arguments.size() || arguments[i + 1][0] == '\0') {
                return "--assets needs a folder.";
            }
            options.assets = arguments[++i];
        } else if (argument.starts_with("--")) {
            return "The option " + std::string(argument) + " is unknown.";
        } else if (have_link) {
            return "There are two links, '" + options.link + "' and '" + std::string(argument) +
                   "': give one (quote it, '&' ends a shell command).";
        } else {
            options.link = argument;
            have_link = true;
        }
    }
    return "";
}

const char* window_usage()
{
    return "Usage: tanklab [LINK] [--assets DIR]\n"
           "Opens the tank in a window, in the state a link describes, such as '#turret=30&distance=40'.\n"
           "  --assets DIR  the folder of a tank's OBJ files and texture, such as the lab's tankobjs\n";
}

} // namespace platform
