#include "platform/offscreen/threshold_measurement.h"

#include "app/state/fields.h"
#include "lod/picture_difference.h"
#include "scene/drawing/read_pixels.h"

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

namespace platform {
namespace {

constexpr int HEADINGS = 12;

constexpr lod::ShowingCriterion CRITERION;

/// Nearer than this the tank fills the picture, and any two models can be told apart. Metres.
constexpr double NEAREST = 20.0;

/// From one metre to the next the outlines meet other pixels, and that is the noise of the measurement.
constexpr double RESOLUTION = 1.0;

struct Measured
{
    lod::PictureDifference difference;
    double heading_degrees = 0.0;
};

/// Draws what the measurement compares.
class Pictures
{
public:
    Pictures(app::Simulation& simulation, const scene::SceneRenderer& renderer, int width, int height)
        : simulation_(simulation), renderer_(renderer), width_(width), height_(height)
    {}

    /// Returns the greatest difference at a distance.
    Measured greatest_difference(double distance)
    {
        simulation_.apply("distance", distance);
        Measured greatest;
        for (int i = 0; i < HEADINGS; ++i) {
            const double degrees = i * 360.0 / HEADINGS - 180.0;
            simulation_.apply("heading", degrees);
            const lod::PictureDifference difference = this->difference();
            if (i == 0 || difference.share() > greatest.difference.share()) {
                greatest = {difference, degrees};
            }
        }
        return greatest;
    }

private:
    lod::PictureDifference difference()
    {
        app::Frame frame = simulation_.frame();
        frame.tanks.truncate(1);
        draw(frame, lod::Level::high, high_);
        draw(frame, lod::Level::low, low_);
        frame.parts = {}; // its shadow stays
        draw(frame, lod::Level::high, without_tank_);
        return *lod::measure_difference(picture(high_), picture(low_), picture(without_tank_), CRITERION);
    }

    void draw(app::Frame& frame, lod::Level level, std::vector<std::uint8_t>& rgba) const
    {
        frame.tanks[0].level = level;
        renderer_.draw(frame, width_, height_);
        rgba = scene::read_pixels(width_, height_);
    }

    lod::Picture picture(const std::vector<std::uint8_t>& rgba) const { return {width_, height_, rgba}; }

    app::Simulation& simulation_;
    const scene::SceneRenderer& renderer_;
    int width_;
    int height_;
    std::vector<std::uint8_t> high_, low_, without_tank_;
};

} // namespace

lod::ThresholdResult measure_threshold(app::Simulation& simulation, const scene::SceneRenderer& renderer,
                                       int width, int height)
{
    Pictures pictures(simulation, renderer, width, height);
    std::printf(
        "The tank in patches of %d x %d pixels, and how many of them differ by more than %d of 255:\n",
        CRITERION.patch, CRITERION.patch, CRITERION.tolerance);
    std::printf("%10s %8s %10s %10s %7s %8s\n", "distance", "heading", "tank", "differing", "share",
                "largest");
    const double furthest = app::field(app::FieldId::distance).maximum;
    return lod::find_threshold({.nearest = NEAREST, .furthest = furthest, .resolution = RESOLUTION},
                               CRITERION, [&](double distance) {
                                   const Measured measured = pictures.greatest_difference(distance);
                                   const lod::PictureDifference& difference = measured.difference;
                                   std::printf("%8.1f m %7.0f° %10zu %10zu %5.1f %% %8d\n", distance,
                                               measured.heading_degrees, difference.tank_pixels,
                                               difference.differing, 100.0 * difference.share(),
                                               difference.largest);
                                   return difference;
                               });
}

void print_threshold(const lod::ThresholdResult& result)
{
    switch (result.outcome) {
    case lod::ThresholdOutcome::found:
        std::printf("d = %.1f m: from there on no difference shows.\n", result.distance);
        break;
    case lod::ThresholdOutcome::shows_nowhere:
        std::printf("d = %.1f m: not even there, where the search ends, a difference shows.\n",
                    result.distance);
        break;
    default:
        std::printf("There is no d: a difference shows even at the furthest distance.\n");
        break;
    }
}

} // namespace platform
