#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace lod {

/// A picture as glReadPixels gives it: rows tightly packed, four bytes a pixel, in either order of rows.
struct Picture
{
    int width;
    int height;
    std::span<const std::uint8_t> rgba; ///< width * height * 4 bytes
};

/// Holds how two pictures of the tank, high and low, drawn in one pose, differ.
struct PictureDifference
{
    std::size_t tank_pixels = 0; ///< where either picture shows the tank
    std::size_t differing = 0;   ///< pixels whose red, green or blue differs by more than the tolerance
    int largest = 0;             ///< the largest difference of a red, green or blue, of 255

    /// Returns the part of the tank's pixels that differ; 0 when no tank is to be seen.
    double share() const;

    friend bool operator==(const PictureDifference&, const PictureDifference&) = default;
};

/// Measures how the pictures of the high and the low tank differ. `tolerance` is of 255.
/// The tank's pixels are those where either picture is not exactly as `without_tank`, the same picture with
/// neither. Alpha does not count. Nothing for pictures of different sizes, or another number of bytes than
/// their size says.
std::optional<PictureDifference> measure_difference(const Picture& high, const Picture& low,
                                                    const Picture& without_tank, int tolerance);

/// Measures the same for pictures on a transparent ground: the tank's pixels are those where either picture's
/// alpha is not 0.
std::optional<PictureDifference> measure_difference(const Picture& high, const Picture& low, int tolerance);

/// Says when a difference shows. A tank at a distance is a few dozen pixels; along its outline some always
/// differ, and nobody sees them.
/// The defaults are where to begin; what is right for a tank, its light and its ground is found by looking.
struct ShowingCriterion
{
    int tolerance = 12;     ///< of 255: for measure_difference
    double share = 0.05;    ///< of the tank's pixels may differ by more than that
    std::size_t pixels = 2; ///< may differ in any case
};

/// Returns whether more pixels differ than the criterion lets pass.
bool shows(const PictureDifference& difference, const ShowingCriterion& criterion);

} // namespace lod
