#include "platform/desktop/window_options.h"

#include "platform/program/arguments.h"

#include <optional>

namespace platform {
namespace {

enum : int
{
    ASSETS = FIRST_OPTION,
    HELP,
};

constexpr option OPTIONS[] = {
    {"assets", required_argument, nullptr, ASSETS},
    {"help", no_argument, nullptr, HELP},
    {},
};

} // namespace

std::string read_window_options(int count, char* const* arguments, WindowOptions& options)
{
    Arguments given(count, arguments, OPTIONS);
    std::optional<std::string> link;
    while (const std::optional<Argument> argument = given.next()) {
        switch (argument->option) {
        case HELP:
            options.help = true;
            return "";
        case ASSETS:
            if (argument->value.empty()) {
                return "--assets needs a folder.";
            }
            options.assets = argument->value;
            break;
        default:
            if (std::string fault = take_link(argument->value, link); !fault.empty()) {
                return fault;
            }
        }
    }
    options.link = link.value_or("");
    return given.fault();
}

const char* window_usage()
{
    return "Usage: tanklab [LINK] [--assets DIR]\n"
           "Opens the tank in a window, in the state a link describes, such as '#turret=30&distance=40'.\n"
           "  --assets DIR  the folder of a tank's OBJ files and texture, such as the lab's tankobjs\n";
}

} // namespace platform
