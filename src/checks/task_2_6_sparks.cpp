#include "app/simulation/simulation.h"
#include "app/state/flight.h"
#include "app/state/ticks.h"
#include "base/measures.h"
#include "checks/check_picture.h"
#include "checks/lab_2_checks.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string_view>
#include <vector>

namespace checks {
namespace {

/// Across the turret, slowly enough that a tick is a few centimetres.
constexpr std::string_view SHOT =
    "line_ax=10&line_ay=2.4&line_az=1&line_bx=0&line_by=2.4&line_bz=1&speed=20&probe=none";

std::size_t alight(const app::Simulation& simulation)
{
    std::size_t live = 0;
    for (const particles::ParticleSystem* system : simulation.sparks().systems()) {
        live += system->live();
    }
    return live;
}

struct Sparks
{
    std::size_t count = 0;
    double furthest = 0.0; ///< from the projectile, metres
    double lowest = 1e9;
};

Sparks sparks_of(const app::Frame& frame, const glm::dvec3& projectile)
{
    Sparks sparks;
    for (const particles::ParticleView& view : frame.particles) {
        for (std::size_t i = 0; i < view.count(); ++i) {
            const glm::dvec3 position(view.position(i));
            ++sparks.count;
            sparks.furthest = std::max(sparks.furthest, glm::distance(position, projectile));
            sparks.lowest = std::min(sparks.lowest, position.y);
        }
    }
    return sparks;
}

/// Steps until `done`, at most ten seconds. Returns whether it came to that.
template <class Done> bool step_until(app::Simulation& simulation, Done done)
{
    for (int tick = 0; tick < 10 * app::TICKS_PER_SECOND; ++tick) {
        if (done()) {
            return true;
        }
        simulation.step();
    }
    return done();
}

void check_burst(const CheckSubject& subject, app::Simulation& simulation, Evidence& evidence)
{
    bool before = false;
    const bool touched = step_until(simulation, [&] {
        before = before || (simulation.touches() == 0 && alight(simulation) != 0);
        return simulation.touches() > 0;
    });
    simulation.step();
    const glm::dvec3 place = app::projectile_position(simulation.state());
    const Sparks sparks = sparks_of(simulation.frame(), place);
    evidence.require(
        touched && !before && sparks.count >= 10 && sparks.furthest < 2.0,
        "Fired across the tank, the projectile throws no sparks before it touches a sphere and " +
            std::to_string(sparks.count) + " when it does, at " + base::in_metres(place) + ".",
        !touched ? "The projectile touches nothing on its way across the turret."
        : before ? "Sparks fly before anything is touched."
                 : "Just after the touch " + std::to_string(sparks.count) + " sparks are alight, up to " +
                       base::in_metres(sparks.furthest) + " m from the projectile.");
    const FrameCapture capture = capture_frame(subject, simulation.frame());
    const bool loads = std::any_of(capture.calls.begin(), capture.calls.end(), [](const LegacyGLCall& call) {
        return std::string_view(call.name).starts_with("glTexImage") ||
               std::string_view(call.name) == "glNewList";
    });
    evidence.require(!loads, "Drawing them loads no texture and compiles no list.",
                     "Drawing them loads a texture or compiles a list in every frame.");
}

/// Returns the mean velocity of the sparks of bursts along Y, m/s; those of the shower are always new.
double mean_rise(const app::Simulation& simulation)
{
    const particles::ParticleView view = simulation.sparks().systems()[0]->view();
    double sum = 0.0;
    for (std::size_t i = 0; i < view.count(); ++i) {
        sum += static_cast<double>(view.velocity(i).y);
    }
    return view.count() == 0 ? 0.0 : sum / static_cast<double>(view.count());
}

void check_falling(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(SHOT);
    simulation.apply("fire", 1.0);
    step_until(simulation, [&] { return simulation.touches() > 0; });
    step_until(simulation, [&] { return alight(simulation) > 20; });
    const double at_first = mean_rise(simulation);
    for (int tick = 0; tick < app::TICKS_PER_SECOND / 4; ++tick) {
        simulation.step();
    }
    const double then = mean_rise(simulation);
    double lowest = 1e9;
    for (int tick = 0; tick < 2 * app::TICKS_PER_SECOND; ++tick) {
        simulation.step();
        lowest = std::min(lowest, sparks_of(simulation.frame(), glm::dvec3(0.0)).lowest);
    }
    evidence.require(then < at_first - 0.8 && lowest > -0.01,
                     "Within a quarter of a second they come to fall by " + base::in_metres(at_first - then) +
                         " m/s, and none goes below the ground.",
                     lowest > -0.01
                         ? "They do not fall: after a quarter of a second they rise by " +
                               base::in_metres(then - at_first) + " m/s more."
                         : "Sparks fall through the ground, to " + base::in_metres(lowest) + " m.");
}

void check_end(app::Simulation& simulation, Evidence& evidence)
{
    const bool inside = simulation.inside().count() > 0;
    const std::size_t alight_inside = alight(simulation);
    const bool left = step_until(simulation, [&] { return simulation.inside().is_empty(); });
    const std::uint64_t touches = simulation.touches();
    const bool out = step_until(simulation, [&] { return alight(simulation) == 0; });
    bool stays_out = true;
    for (int tick = 0; tick < 2 * app::TICKS_PER_SECOND; ++tick) {
        simulation.step();
        stays_out = stays_out && alight(simulation) == 0;
    }
    evidence.require(inside && alight_inside > 0 && left && out && stays_out &&
                         simulation.touches() == touches,
                     "It showers while the projectile is inside; when it has left, the last spark goes out.",
                     !left  ? "The projectile does not leave the tank again."
                     : !out ? std::to_string(alight(simulation)) + " sparks are alight ten seconds after the "
                                                                   "projectile has left."
                            : "Sparks go on after the projectile has left.");
}

/// Returns how many pixels are darker in `after` than in `before`, and how many are brighter.
std::pair<std::size_t, std::size_t> darker_and_brighter(const std::vector<std::uint8_t>& before,
                                                        const std::vector<std::uint8_t>& after)
{
    std::size_t darker = 0;
    std::size_t brighter = 0;
    for (std::size_t i = 0; i < before.size(); i += 4) {
        bool less = false;
        bool more = false;
        for (std::size_t channel = i; channel < i + 3; ++channel) {
            less = less || after[channel] < before[channel];
            more = more || after[channel] > before[channel];
        }
        darker += less ? 1u : 0u;
        brighter += more ? 1u : 0u;
    }
    return {darker, brighter};
}

/// Light adds to light. And what is drawn after sparks must look as if there had been none: the next frame.
void check_picture(const CheckSubject& subject, app::Simulation& simulation, Evidence& evidence)
{
    const app::Frame frame = simulation.frame();
    app::Frame without = frame;
    without.particles.clear();
    const auto before = picture_of(subject, without);
    const auto with = picture_of(subject, frame);
    const auto after = picture_of(subject, without);
    const auto [darker, brighter] = darker_and_brighter(before, with);
    evidence.require(
        darker == 0 && brighter > 0, "They brighten " + std::to_string(brighter) + " pixels and darken none.",
        "They darken " + std::to_string(darker) + " pixels and brighten " + std::to_string(brighter) + ".");
    evidence.require(before == after,
                     "The tank is drawn after them as before: its light, texture and blending are its own.",
                     "The picture without sparks is another one after sparks were drawn.");
}

} // namespace

void check_sparks(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(SHOT);
    simulation.apply("fire", 1.0);
    check_burst(subject, simulation, evidence);
    step_until(simulation, [&] { return simulation.inside().count() > 0 && alight(simulation) > 30; });
    check_picture(subject, simulation, evidence);
    check_end(simulation, evidence);
    check_falling(subject, evidence);
}

} // namespace checks
