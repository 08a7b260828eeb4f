#include "app/commands/commands.h"
#include "app/simulation/simulation.h"
#include "app/state/ticks.h"
#include "base/measures.h"
#include "checks/check_picture.h"
#include "checks/lab_3_checks.h"
#include "lod/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace checks {
namespace {

constexpr std::string_view TASK = "task=3.2";

/// The window that d was measured in; a larger one shows more, a smaller one less. Pixels.
constexpr int MEASURED_WIDTH = 1280;
constexpr int MEASURED_HEIGHT = 800;

/// Holds a key until the distance stays what it is, at most a minute.
void zoom_to_the_end(app::Simulation& simulation, std::string_view command)
{
    simulation.apply(command, 1.0);
    double before = -1.0;
    for (int tick = 0; tick < 60 * app::TICKS_PER_SECOND && before != simulation.state().camera.distance;
         ++tick) {
        before = simulation.state().camera.distance;
        simulation.step();
    }
    simulation.apply(command, 0.0);
}

/// Returns how much of the picture the tank is: the share of pixels that are others without it.
double share_of_tank(const CheckSubject& subject, const app::Frame& frame)
{
    app::Frame without = frame;
    without.tanks.clear();
    return share_of_other_pixels(picture_of(subject, frame), picture_of(subject, without));
}

void check_moving_away(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(TASK);
    const app::Frame first = simulation.frame();
    const double near_share = share_of_tank(subject, first);
    zoom_to_the_end(simulation, "zoom_out");
    const app::Frame last = simulation.frame();
    const double far_share = share_of_tank(subject, last);
    const glm::dvec3 way = last.camera.centre - last.camera.eye;
    const double distance = simulation.state().camera.distance;
    const bool along_z =
        std::fabs(way.x) < 1e-6 * distance && std::fabs(way.y) < 1e-6 * distance && way.z < 0.0;
    const bool only_low = first.tanks.size() == 1 && first.tanks[0].level == lod::Level::low &&
                          last.tanks[0].level == lod::Level::low;
    evidence.require(only_low && along_z && distance >= 300.0 && far_share > 0.0 &&
                         near_share > far_share * 20,
                     "The low tank alone moves away along -Z by the key, to " + base::in_metres(distance) +
                         " m, and can still be seen there.",
                     !only_low          ? "It is not the low tank alone."
                     : !along_z         ? "The eye does not look along -Z."
                     : distance < 300.0 ? "It goes no further away than " + base::in_metres(distance) + " m."
                                        : "At " + base::in_metres(distance) +
                                              " m nothing of it is drawn, or it has not become smaller: the "
                                              "far plane cuts it off.");
}

/// Measures how the models differ at a distance, as a person with the window of the lab would see it.
lod::PictureDifference difference_at(const CheckSubject& subject, double distance,
                                     const lod::ShowingCriterion& criterion)
{
    // d is measured at 1280 x 800; a larger window shows more, a smaller one less.
    CheckSubject window{subject.assets, subject.renderer, std::min(subject.width, MEASURED_WIDTH),
                        std::min(subject.height, MEASURED_HEIGHT)};
    app::Simulation simulation(subject.assets);
    simulation.open_link(TASK);
    simulation.apply("distance", distance);
    const auto picture = [&](lod::Level level, std::size_t tanks) {
        app::Frame frame = simulation.frame();
        frame.tanks[0].level = level;
        frame.tanks.truncate(tanks);
        return picture_of(window, frame);
    };
    const auto high = picture(lod::Level::high, 1);
    const auto low = picture(lod::Level::low, 1);
    const auto none = picture(lod::Level::low, 0);
    const auto as_picture = [&](const std::vector<std::uint8_t>& rgba) {
        return lod::Picture{window.width, window.height, rgba};
    };
    return lod::measure_difference(as_picture(high), as_picture(low), as_picture(none), criterion)
        .value_or(lod::PictureDifference{});
}

std::string percent(double share)
{
    return std::to_string(std::lround(share * 100.0)) + " %";
}

void check_difference(const CheckSubject& subject, Evidence& evidence)
{
    const double d = app::State{}.show.threshold;
    // In a lower window the tank is as small as in the one of the measurement further away.
    const double as_seen = d * std::min(subject.height, MEASURED_HEIGHT) / MEASURED_HEIGHT;
    const lod::ShowingCriterion criterion;
    // From near by an eye sees not only patches but every pixel.
    const lod::ShowingCriterion pixels{.patch = 1};
    const lod::PictureDifference beyond = difference_at(subject, as_seen * 1.02, criterion);
    const lod::PictureDifference inside = difference_at(subject, as_seen / 10.0, pixels);
    evidence.require(beyond.tank_pixels > 0 && !lod::shows(beyond, criterion),
                     "Beyond the d of " + base::in_metres(d) + " m high and low differ in " +
                         percent(beyond.share()) + " of the tank's patches: nobody sees that.",
                     "Beyond the d of " + base::in_metres(d) + " m high and low differ in " +
                         std::to_string(beyond.differing) + " of the tank's " +
                         std::to_string(beyond.tank_pixels) + " patches.");
    evidence.require(lod::shows(inside, pixels),
                     "Well inside of it they differ in " + percent(inside.share()) + " of its pixels.",
                     "Well inside of it they differ in only " + percent(inside.share()) +
                         " of its pixels: the threshold could be nearer.");
}

void check_noting(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(TASK);
    simulation.apply("distance", 73.5);
    const app::Command* command = app::find_command("note_threshold");
    simulation.apply("note_threshold", 1.0);
    evidence.require(command != nullptr && command->keys[0] != app::Key::none &&
                         simulation.state().show.threshold == simulation.state().camera.distance,
                     "A key makes the distance the threshold d.",
                     "No key makes the distance the threshold d.");
}

} // namespace

void check_threshold(const CheckSubject& subject, Evidence& evidence)
{
    check_moving_away(subject, evidence);
    check_difference(subject, evidence);
    check_noting(subject, evidence);
}

} // namespace checks
