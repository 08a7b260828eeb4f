#include "platform/offscreen/render_options.h"

#include "platform/program/arguments.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace platform {
namespace {

enum : int
{
    SIZE = FIRST_OPTION,
    RENDERER,
    OUT,
    ASSETS,
    STATE,
    MEASURE_THRESHOLD,
    HELP,
};

constexpr option OPTIONS[] = {
    {"size", required_argument, nullptr, SIZE},
    {"renderer", required_argument, nullptr, RENDERER},
    {"out", required_argument, nullptr, OUT},
    {"assets", required_argument, nullptr, ASSETS},
    {"state", no_argument, nullptr, STATE},
    {"measure-threshold", no_argument, nullptr, MEASURE_THRESHOLD},
    {"help", no_argument, nullptr, HELP},
    {},
};

/// Reads a whole decimal number from 1 to MAX_PICTURE_SIDE; anything else is nothing.
std::optional<int> read_side(std::string_view text)
{
    int side = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, side);
    if (fault != std::errc{} || stop != end || side < 1 || side > MAX_PICTURE_SIDE) {
        return std::nullopt;
    }
    return side;
}

std::string read_size(std::string_view text, RenderOptions& options)
{
    const std::size_t cross = text.find('x');
    if (cross != std::string_view::npos) {
        const std::optional<int> width = read_side(text.substr(0, cross));
        const std::optional<int> height = read_side(text.substr(cross + 1));
        if (width && height) {
            options.width = *width;
            options.height = *height;
            return "";
        }
    }
    return "--size " + std::string(text) +
           " cannot be drawn: it needs WIDTHxHEIGHT in pixels, each from 1 to " +
           std::to_string(MAX_PICTURE_SIDE) + ", such as 960x540.";
}

std::string read_renderer(std::string_view text, RenderOptions& options)
{
    if (text == "emulated") {
        options.renderer = RendererName::emulated;
    } else if (text == "reference") {
        options.renderer = RendererName::reference;
    } else {
        return (text.empty() ? "--renderer needs a value"
                             : "--renderer " + std::string(text) + " is unknown") +
               ": it is emulated (legacygl) or reference (the system's OpenGL).";
    }
    return "";
}

std::string read_path(std::string_view name, const std::string& text, std::string& path)
{
    path = text;
    return text.empty() ? std::string(name) + " needs a path." : "";
}

/// Takes an argument. Returns "" or what is wrong with it.
std::string use(const Argument& argument, RenderOptions& options, std::optional<std::string>& link)
{
    switch (argument.option) {
    case SIZE:
        return read_size(argument.value, options);
    case RENDERER:
        return read_renderer(argument.value, options);
    case OUT:
        return read_path("--out", argument.value, options.out);
    case ASSETS:
        return read_path("--assets", argument.value, options.assets);
    case STATE:
        options.state = true;
        return "";
    case MEASURE_THRESHOLD:
        options.measure_threshold = true;
        return "";
    default:
        return take_link(argument.value, link);
    }
}

void fill_in_size(RenderOptions& options)
{
    if (options.width == 0) {
        options.width = options.measure_threshold ? 1280 : 960;
        options.height = options.measure_threshold ? 800 : 540;
    }
}

} // namespace

std::string read_render_options(int count, char* const* arguments, RenderOptions& options)
{
    Arguments given(count, arguments, OPTIONS);
    std::optional<std::string> link;
    while (const std::optional<Argument> argument = given.next()) {
        if (argument->option == HELP) {
            options.help = true;
            return "";
        }
        if (std::string fault = use(*argument, options, link); !fault.empty()) {
            return fault;
        }
    }
    if (!given.fault().empty()) {
        return given.fault();
    }
    if (!link && !options.measure_threshold) {
        return "There is no link: give one, such as '#turret=30', or '' for the tank as it starts.";
    }
    options.link = link.value_or("task=3.2"); // the handout's camera
    fill_in_size(options);
    if (options.out.empty() && !options.state && !options.measure_threshold) {
        return "There is nothing to do: give --out FILE.png, --state, --measure-threshold or several.";
    }
    return "";
}

const char* render_usage()
{
    return "Usage: tanklab-render LINK [--renderer emulated|reference] [--size WxH] [--out FILE.png] "
           "[--state]\n"
           "                      [--assets DIR]\n"
           "       tanklab-render [LINK] --measure-threshold [--renderer emulated|reference] [--size WxH]\n"
           "Draws the state a link describes, such as '#turret=30&distance=40', without a window.\n"
           "  --renderer emulated   through legacygl on OpenGL ES 3 (the default)\n"
           "  --renderer reference  through the system's own OpenGL\n"
           "  --size WxH            the picture's size in pixels (default 960x540)\n"
           "  --out FILE.png        where the picture goes\n"
           "  --state               prints the state as JSON; without --out, draws nothing\n"
           "  --measure-threshold   measures from which distance on the high and the low model cannot be "
           "told\n"
           "                        apart, and prints what it saw at each; without a link, as task 3.2 has\n"
           "                        them, and in 1280x800\n"
           "  --assets DIR          the folder of a tank's OBJ files and texture, such as the lab's "
           "tankobjs\n";
}

} // namespace platform
