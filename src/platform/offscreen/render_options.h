#pragma once

#include <string>

namespace platform {

enum class RendererName
{
    emulated, ///< legacygl on OpenGL ES 3
    reference ///< the system's own OpenGL
};

/// What `tanklab-render` is asked to do.
struct RenderOptions
{
    std::string link; ///< A fragment, with or without '#', or a whole address that ends in one.
    RendererName renderer = RendererName::emulated;
    int width = 0;      ///< pixels
    int height = 0;     ///< pixels
    std::string out;    ///< The PNG file to write; "" when only the state is asked for.
    std::string assets; ///< The folder of the tank's files; "": the one that comes with the program.
    bool state = false;
    bool measure_threshold = false;
    bool help = false;
};

/// The longest side of a picture in pixels; OpenGL ES 3 need not go further than 2048, Mesa reaches 8192.
inline constexpr int MAX_PICTURE_SIDE = 8192;

/// Reads the program's arguments, which begin with its name, into `options`; once in a process.
/// Returns "" or a sentence that names the argument that is wrong.
std::string read_render_options(int count, char* const* arguments, RenderOptions& options);

/// Returns the help text of `tanklab-render`.
const char* render_usage();

} // namespace platform
