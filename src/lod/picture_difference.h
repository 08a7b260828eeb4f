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

/// Says when a difference shows. One colour a face cannot have the spots of camouflage, and without
/// antialiasing no two outlines are the same pixels: compared pixel by pixel the models differ however far
/// away they are. What an eye notices of a tank of a few dozen pixels are patches of it that change.
/// The numbers are for a tank on open ground in a window of 1280 x 800, and were found by looking at pairs of
/// pictures from 40 m to 400 m away.
struct ShowingCriterion
{
    int patch = 4;          ///< so many pixels each way are averaged before anything is compared
    int tolerance = 48;     ///< of 255: patches that differ by no more are as good as the same
    double share = 0.05;    ///< of the tank's patches may differ by more than that
    std::size_t pixels = 1; ///< patches may differ in any case
};

/// Measures the same as a criterion has it: by patches, which then are the pixels of the result.
std::optional<PictureDifference> measure_difference(const Picture& high, const Picture& low,
                                                    const Picture& without_tank,
                                                    const ShowingCriterion& criterion);

/// Returns whether more patches differ than the criterion lets pass.
bool shows(const PictureDifference& difference, const ShowingCriterion& criterion);

} // namespace lod
