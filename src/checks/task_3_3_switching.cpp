#include "app/simulation/simulation.h"
#include "base/measures.h"
#include "checks/lab_3_checks.h"

#include <string_view>

namespace checks {
namespace {

/// What a frame draws the tank with.
enum class Shown : std::uint8_t
{
    high,
    low,
    neither, ///< or a mixture
};

Shown shown(const CheckSubject& subject, const app::Simulation& simulation)
{
    const FrameCapture capture = capture_frame(subject, simulation.frame());
    const std::size_t high = capture.tank_list_calls.size();
    const std::size_t low = capture.low_list_calls.size();
    return high == tank::PART_COUNT && low == 0   ? Shown::high
           : low == tank::PART_COUNT && high == 0 ? Shown::low
                                                  : Shown::neither;
}

/// Holds a key until the distance is on the other side of `end`; counts how often what is drawn changes.
struct Crossing
{
    std::size_t switches = 0;
    double at = 0.0; ///< the distance of the last one
    bool mixed = false;
    Shown last;
};

Crossing cross(const CheckSubject& subject, app::Simulation& simulation, std::string_view command, double end)
{
    Crossing crossing{.last = shown(subject, simulation)};
    const bool outwards = end > simulation.state().camera.distance;
    simulation.apply(command, 1.0);
    for (int tick = 0; tick < 600 && (simulation.state().camera.distance < end) == outwards; ++tick) {
        simulation.step();
        const Shown now = shown(subject, simulation);
        crossing.mixed = crossing.mixed || now == Shown::neither;
        if (now != crossing.last) {
            ++crossing.switches;
            crossing.at = simulation.state().camera.distance;
        }
        crossing.last = now;
    }
    simulation.apply(command, 0.0);
    return crossing;
}

void check_crossings(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link("task=3.3");
    const double d = simulation.state().show.threshold;
    simulation.apply("distance", d * 0.8);
    const Crossing out = cross(subject, simulation, "zoom_out", d * 1.25);
    const Crossing back = cross(subject, simulation, "zoom_in", d * 0.8);
    const auto near_d = [d](double at) { return at > d * 0.9 && at < d * 1.1; };
    evidence.require(
        out.switches == 1 && out.last == Shown::low && near_d(out.at) && !out.mixed,
        "Going out past d = " + base::in_metres(d) + " m by key, the 18 lists of the high tank give way " +
            "to those of the low one once, at " + base::in_metres(out.at) + " m.",
        "Going out past d = " + base::in_metres(d) + " m, what is drawn changes " +
            std::to_string(out.switches) + " times, the last time at " + base::in_metres(out.at) + " m.");
    evidence.require(back.switches == 1 && back.last == Shown::high && near_d(back.at) && !back.mixed,
                     "Coming back it changes once, at " + base::in_metres(back.at) + " m.",
                     "Coming back it changes " + std::to_string(back.switches) + " times.");
    evidence.require(out.at > back.at, "It changes further away going out than coming back.",
                     "It changes at one and the same distance both ways, and would flicker there.");
}

void check_trembling(const CheckSubject& subject, Evidence& evidence)
{
    std::size_t switches = 0;
    for (double first : {0.8, 1.25}) {
        app::Simulation simulation(subject.assets);
        simulation.open_link("task=3.3");
        const double d = simulation.state().show.threshold;
        simulation.apply("distance", d * first);
        simulation.apply("distance", d);
        Shown last = shown(subject, simulation);
        for (int i = 0; i < 40; ++i) {
            simulation.apply("distance", d + (i % 2 == 0 ? 0.004 : -0.004) * d);
            simulation.step();
            const Shown now = shown(subject, simulation);
            switches += now != last ? 1u : 0u;
            last = now;
        }
    }
    evidence.require(switches == 0, "Trembling by a few thousandths of d about it, nothing changes.",
                     "Trembling about d changes the model " + std::to_string(switches) + " times.");
}

void check_forcing(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link("task=3.3&detail=high&distance=200");
    const bool high = shown(subject, simulation) == Shown::high;
    simulation.open_link("task=3.3&detail=low&distance=20");
    const bool low = shown(subject, simulation) == Shown::low;
    // What is tested stays the high model's.
    const double root = simulation.spheres().hierarchy().root().radius;
    simulation.open_link("task=3.3&detail=high&distance=20");
    const bool same = simulation.spheres().hierarchy().root().radius == root;
    evidence.require(high && low && same,
                     "Asked for, either model is drawn at any distance, and the spheres stay the same.",
                     "The model asked for is not the one drawn, or the spheres change with it.");
}

} // namespace

void check_switching(const CheckSubject& subject, Evidence& evidence)
{
    check_crossings(subject, evidence);
    check_trembling(subject, evidence);
    check_forcing(subject, evidence);
}

} // namespace checks
