#include "assets/corner_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace assets {

namespace {

/// The corners are held to the mean of the whole triangle by so much of its weight: one near which nothing
/// was seen is then no colour of its own.
constexpr double HELD = 0.02;

/// A fit loses what is smaller than the triangle, and an eye sees the lack of contrast before it sees a patch
/// in a wrong place. So the corners differ more than the fit has it: in lightness as much as what was seen
/// does, but at most so many times; in hue so many times, as patches of camouflage are large.
constexpr double MAX_STRETCH = 3.0;
constexpr double HUE_STRETCHED = 1.4;

/// How light red, green and blue are: ITU-R BT.709.
constexpr glm::dvec3 LIGHTNESS{0.2126, 0.7152, 0.0722};

} // namespace

void CornerFit::add(const glm::vec3& colour, const glm::dvec3& parts, double weight)
{
    const glm::dvec3 seen(colour);
    parts_ += weight * glm::outerProduct(parts, parts);
    colours_ += weight * glm::outerProduct(seen, parts);
    sum_ += weight * seen;
    squares_ += weight * glm::dot(LIGHTNESS, seen) * glm::dot(LIGHTNESS, seen);
    weight_ += weight;
    least_ = glm::min(least_, seen);
    most_ = glm::max(most_, seen);
}

std::optional<std::array<glm::vec3, 3>> CornerFit::corners() const
{
    if (!(weight_ > 0.0)) {
        return std::nullopt;
    }
    const double hold = HELD * weight_;
    const glm::dmat3 means(mean(), mean(), mean());
    // The normal equations (off * (parts + hold) = colours - mean), for what the corners are off the mean by.
    const glm::dmat3 off = (colours_ - means * parts_) * glm::inverse(parts_ + glm::dmat3(hold));
    const double more = stretch(off);
    std::array<glm::vec3, 3> result;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 lighter(glm::dot(LIGHTNESS, off[i]));
        const glm::dvec3 colour = mean() + more * lighter + HUE_STRETCHED * (off[i] - lighter);
        result[static_cast<std::size_t>(i)] = glm::vec3(glm::clamp(colour, least_, most_));
    }
    return result;
}

/// Returns how many times further off the mean in lightness the corners have to be for what lies between them
/// to vary as much as what was seen does.
double CornerFit::stretch(const glm::dmat3& off) const
{
    const double usual = glm::dot(LIGHTNESS, mean());
    const double seen = squares_ / weight_ - usual * usual;
    const glm::dvec3 lighter = LIGHTNESS * off;
    const double fitted = glm::dot(lighter, parts_ * lighter) / weight_;
    const double rounding = 1e-9;
    return fitted > rounding ? std::clamp(std::sqrt(std::max(seen, 0.0) / fitted), 1.0, MAX_STRETCH) : 1.0;
}

} // namespace assets
