#include "checks/check_picture.h"

#include "scene/drawing/read_pixels.h"

#include <algorithm>

namespace checks {

std::vector<std::uint8_t> picture_of(const CheckSubject& subject, const app::Frame& frame)
{
    subject.renderer.draw(frame, subject.width, subject.height);
    return scene::read_pixels(subject.width, subject.height);
}

double share_of_other_pixels(const std::vector<std::uint8_t>& one, const std::vector<std::uint8_t>& other)
{
    std::size_t differing = 0;
    for (std::size_t i = 0; i < one.size(); i += 4) {
        const auto pixel = static_cast<std::ptrdiff_t>(i);
        differing +=
            std::equal(one.begin() + pixel, one.begin() + pixel + 3, other.begin() + pixel) ? 0u : 1u;
    }
    return static_cast<double>(differing) * 4.0 / static_cast<double>(one.size());
}

} // namespace checks
