#include "app/simulation/simulation.h"

#include "app/commands/update.h"
#include "app/simulation/particle_show.h"
#include "app/state/flight.h"
#include "base/measures.h"
#include "base/text.h"

namespace app {

namespace {

bool same_probe(const Projectile& one, const Projectile& other)
{
    return one.probe == other.probe && one.point == other.point && one.radius == other.radius &&
           one.a == other.a && one.b == other.b;
}

} // namespace

Simulation::Simulation(const assets::Assets& assets)
    : lab_(&assets), assets_(&assets), spheres_(assets), triangles_(assets)
{
    update_level(true);
    begin_event();
    set_up_particles();
}

std::string Simulation::apply(const Command& command, double value)
{
    const State before = state_;
    std::string fault = app::apply(state_, *assets_, command, value);
    follow(before);
    return fault;
}

std::string Simulation::apply(std::string_view name, double value)
{
    const Command* command = find_command(name);
    return command == nullptr ? "There is no command " + base::in_quotes(name) + "." : apply(*command, value);
}

void Simulation::step()
{
    const State before = state_;
    const bool has_come_to_rest = motion_.step();
    app::step(state_, *assets_);
    follow(before);
    if (has_come_to_rest) {
        ++state_.revision.count;
    }
    meet();
}

void Simulation::bring(const assets::Assets* own)
{
    own_ = own;
    if (choose_tank()) {
        ++state_.revision.count;
        update_report(false);
        if (state_.event.kind == EventKind::none) {
            begin_event();
        } else {
            replay();
        }
    }
}

/// Makes the tank that the state asks for the one that is shown. Returns whether it is another one now.
bool Simulation::choose_tank()
{
    const assets::Assets* chosen = state_.tank == TankShown::own && own_ != nullptr ? own_ : lab_;
    if (chosen == assets_) {
        return false;
    }
    assets_ = chosen;
    spheres_ = TankSpheres(*assets_);
    spheres_.refit(state_);
    triangles_ = TankTriangles(*assets_);
    return true;
}

LinkResult Simulation::open_link(std::string_view fragment)
{
    const State before = state_;
    LinkResult result = app::open_link(state_, fragment);
    follow(before);
    return result;
}

/// Brings everything up to date after the state has changed.
void Simulation::follow(const State& before)
{
    const bool is_other_tank = choose_tank();
    const bool has_moved = spheres_.refit(state_) || is_other_tank;
    const bool is_opened = state_.revision.openings != before.revision.openings;
    const bool is_asked = state_.revision.prints != before.revision.prints;
    const bool is_other_test = state_.show.triangles != before.show.triangles;
    if (has_moved || is_opened || is_asked || is_other_test ||
        !same_probe(before.projectile, state_.projectile)) {
        update_report(is_asked);
    }
    update_level(is_opened);
    if (is_opened) {
        motion_.forget();
    } else {
        motion_.follow(before, state_);
    }
    if (is_opened || state_.particles != before.particles) {
        set_up_particles();
    }
    if (is_opened) {
        replay();
    } else if (is_other_tank || state_.seed != before.seed) {
        begin_event();
    } else if (before.shot.flies && !state_.shot.flies) {
        // The projectile is back where it rests, and stays inside of what it is inside of there.
        contacts_.forget();
        if (state_.projectile.probe == Probe::point) {
            contacts_.place(state_.projectile.point, state_.projectile.radius, spheres_.hierarchy());
        }
    }
}

/// Lets what the state has under way happen again, from its event on.
void Simulation::replay()
{
    const std::uint32_t age = state_.event.age;
    app::begin_event(state_, state_.event.kind, 0);
    state_.tick = 0;
    sparks_.put_out(); // a link says all there is, and nothing of what was before it
    begin_event();
    const Camera camera = state_.camera; // a link says where the eye is now, not where it was then
    for (std::uint32_t tick = 0; tick < age; ++tick) {
        step();
    }
    state_.camera = camera;
}

/// Begins the contacts and sparks of the state's event.
void Simulation::begin_event()
{
    sparks_.begin(state_.seed);
    particles_.restart(state_.seed); // as a link of this event will
    contacts_.forget();
    touches_ = 0;
    if (state_.shot.flies) {
        contacts_.launch(position_of(state_.shot));
    } else if (state_.event.kind == EventKind::none && state_.projectile.probe == Probe::point) {
        contacts_.place(state_.projectile.point, state_.projectile.radius, spheres_.hierarchy());
    }
}

void Simulation::set_up_particles()
{
    // The settings follow from fields within their limits, so there is no fault in them; a test tries all.
    static_cast<void>(particles_.configure(app::shown_particles(state_)));
    particles_.restart(state_.seed);
}

void Simulation::update_level(bool is_opened)
{
    const double distance = eye_distance(state_);
    if (is_opened) {
        level_.start(distance, state_.show.threshold);
        level_switches_ = 0;
    } else if (level_.update(distance, lod::band_by_fraction(state_.show.threshold))) {
        ++level_switches_;
        ++state_.revision.count;
    }
}

/// Lets the projectile meet the spheres on the way of this step, and the sparks fly.
void Simulation::meet()
{
    const bool is_there = state_.shot.flies || state_.projectile.probe == Probe::point;
    const std::optional<glm::dvec3> position =
        is_there ? std::optional(projectile_position(state_)) : std::nullopt;
    contacts_.move(position, state_.projectile.radius, spheres_.hierarchy(),
                   [this](std::size_t part, const glm::dvec3& place) {
                       ++touches_;
                       sparks_.burst(place);
                       log_.note("The projectile touches " +
                                 std::string(tank::part_name(static_cast<tank::Part>(part))) + " at " +
                                 base::in_metres(place) + ".");
                   });
    sparks_.shower(contacts_.inside().is_empty() ? std::nullopt : position);
    const bool was_active = sparks_.is_active() || particles_.is_active();
    constexpr double SECONDS = 1.0 / TICKS_PER_SECOND;
    sparks_.step(SECONDS);
    particles_.step(SECONDS);
    if (was_active) {
        ++state_.revision.count;
    }
}

lod::Level Simulation::level() const
{
    return level_.level == lod::Level::low ? lod::Level::low : lod::Level::high;
}

std::uint64_t Simulation::hash() const
{
    std::uint64_t hash = app::hash(state_);
    for (std::uint64_t part :
         {contacts_.inside().bits(), touches_, sparks_.hash(), particles::hash(particles_)}) {
        hash = (hash ^ part) * 0x100000001b3;
    }
    return hash;
}

void Simulation::update_report(bool is_asked)
{
    if (state_.projectile.probe == Probe::none && report_.probe == Probe::none && !is_asked) {
        return;
    }
    report_ = hit_report(state_, spheres_.hierarchy());
    if (state_.show.triangles) {
        test_triangles(report_, triangles_, spheres_.matrices());
    }
    log_.print(report_lines(report_), is_asked);
}

} // namespace app
