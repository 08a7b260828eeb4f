#include "platform/offscreen/render_options.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace platform {
namespace {

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
        return "--renderer " + std::string(text) +
               " is unknown: it is emulated (legacygl) or reference (the "
               "system's OpenGL).";
    }
    return "";
}

/// Reads one option that takes a value.
std::string read_valued(std::string_view name, std::string_view value, RenderOptions& options)
{
    if (name == "--size") {
        return read_size(value, options);
    }
    if (name == "--renderer") {
        return read_renderer(value, options);
    }
    if (value.empty()) {
        return std::string(name) + " needs a path.";
    }
    (name == "--out" ? options.out : options.assets) = value;
    return "";
}

/// Fills in what was not given, where it may be left out.
void fill_in_defaults(bool have_link, RenderOptions& options)
{
    if (options.measure_threshold && !have_link) {
        options.link = "task=3.2"; // the handout's camera
    }
    if (options.width == 0) {
        options.width = options.measure_threshold ? 1280 : 960;
        options.height = options.measure_threshold ? 800 : 540;
    }
}

bool takes_value(std::string_view name)
{
    return name == "--size" || name == "--renderer" || name == "--out" || name == "--assets";
}

} // namespace

std::string read_render_options(std::span<const char* const> arguments, RenderOptions& options)
{
    bool have_link = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--help") {
            options.help = true;
            return "";
        }
        if (argument == "--state") {
            options.state = true;
        } else if (argument == "--measure-threshold") {
            options.measure_threshold = true;
        } else if (takes_value(argument)) {
            if (i + 1 == arguments.size()) {
                return std::string(argument) + " needs a value.";
            }
            if (std::string error = read_valued(argument, arguments[++i], options); !error.empty()) {
                return error;
            }
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
    fill_in_defaults(have_link, options);
    if (!have_link && !options.measure_threshold) {
        return "There is no link: give one, such as '#turret=30', or '' for the tank as it starts.";
    }
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
