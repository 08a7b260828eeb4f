#include "lod/picture_difference.h"

#include "lod/reduced_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lod {

namespace {

constexpr std::size_t CHANNELS = 4;

bool is_whole(const Picture& picture)
{
    return picture.width >= 0 && picture.height >= 0 &&
           picture.rgba.size() / CHANNELS ==
               static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) &&
           picture.rgba.size() % CHANNELS == 0;
}

bool is_same_size(const Picture& a, const Picture& b)
{
    return a.width == b.width && a.height == b.height;
}

/// Returns the largest difference of the red, green or blue of the pixel that begins at that byte.
int difference_at(const Picture& a, const Picture& b, std::size_t byte)
{
    int largest = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        largest = std::max(largest, std::abs(a.rgba[byte + channel] - b.rgba[byte + channel]));
    }
    return largest;
}

template <class IsTank>
std::optional<PictureDifference> measured(const Picture& high, const Picture& low, int tolerance,
                                          IsTank is_tank)
{
    if (!is_whole(high) || !is_whole(low) || !is_same_size(high, low)) {
        return std::nullopt;
    }
    PictureDifference result;
    for (std::size_t byte = 0; byte < high.rgba.size(); byte += CHANNELS) {
        const int difference = difference_at(high, low, byte);
        result.largest = std::max(result.largest, difference);
        result.differing += difference > tolerance ? 1 : 0;
        result.tank_pixels += is_tank(byte) ? 1 : 0;
    }
    return result;
}

} // namespace

double PictureDifference::share() const
{
    return tank_pixels == 0 ? 0.0 : static_cast<double>(differing) / static_cast<double>(tank_pixels);
}

std::optional<PictureDifference> measure_difference(const Picture& high, const Picture& low,
                                                    const Picture& without_tank, int tolerance)
{
    if (!is_whole(without_tank) || !is_same_size(high, without_tank)) {
        return std::nullopt;
    }
    return measured(high, low, tolerance, [&](std::size_t byte) {
        return difference_at(high, without_tank, byte) > 0 || difference_at(low, without_tank, byte) > 0;
    });
}

std::optional<PictureDifference> measure_difference(const Picture& high, const Picture& low, int tolerance)
{
    return measured(high, low, tolerance,
                    [&](std::size_t byte) { return high.rgba[byte + 3] != 0 || low.rgba[byte + 3] != 0; });
}

std::optional<PictureDifference> measure_difference(const Picture& high, const Picture& low,
                                                    const Picture& without_tank,
                                                    const ShowingCriterion& criterion)
{
    if (!is_whole(high) || !is_whole(low) || !is_whole(without_tank)) {
        return std::nullopt;
    }
    return measure_difference(reduced(high, criterion.patch).view(), reduced(low, criterion.patch).view(),
                              reduced(without_tank, criterion.patch).view(), criterion.tolerance);
}

bool shows(const PictureDifference& difference, const ShowingCriterion& criterion)
{
    const double allowed = std::max(static_cast<double>(criterion.pixels),
                                    criterion.share * static_cast<double>(difference.tank_pixels));
    return static_cast<double>(difference.differing) > allowed;
}

} // namespace lod
