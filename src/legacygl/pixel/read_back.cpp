#include "legacygl/pixel/read_back.h"

#include <algorithm>

namespace legacygl {

PixelRectangle clip_to_frame(const Context& gl, int x, int y, int width, int height)
{
    // In 64 bits: the ends of a rectangle at the edge of all integers do not fit into 32.
    const auto begin = [](int at) { return std::max(at, 0); };
    const auto length = [&](int at, int size, int limit) {
        const auto end = std::min(static_cast<std::int64_t>(at) + size, static_cast<std::int64_t>(limit));
        return static_cast<int>(std::max<std::int64_t>(0, end - begin(at)));
    };
    return {begin(x),
            begin(y),
            length(x, width, gl.backend->target_width),
            length(y, height, gl.backend->target_height),
            begin(x) - x,
            begin(y) - y};
}

std::vector<std::uint8_t> read_frame(Context& gl, const PixelRectangle& r)
{
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(r.width) * r.height * 4);
    gl.backend->read_pixels(gl.state.fragment.reads_front(), r.x, r.y, r.width, r.height, rgba);
    return rgba;
}

} // namespace legacygl
