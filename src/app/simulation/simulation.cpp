#include "app/simulation/simulation.h"

#include "app/commands/update.h"
#include "app/simulation/particle_show.h"
#include "app/state/flight.h"
#include "base/measures.h"
#include "base/text.h"

namespace app {

namespace {

/// The fields that say what is tested and how.
constexpr FieldId PROBE_FIELDS[] = {FieldId::probe,   FieldId::point_x,      FieldId::point_y,
                                    FieldId::point_z, FieldId::point_radius, FieldId::line_ax,
                                    FieldId::line_ay, FieldId::line_az,      FieldId::line_bx,
                                    FieldId::line_by, FieldId::line_bz,      FieldId::triangles};

constexpr FieldId PARTICLE_FIELDS[] = {FieldId::particles, FieldId::amount};

bool any_of(const FieldSet& fields, std::span<const FieldId> ids)
{
    return std::any_of(ids.begin(), ids.end(),
                       [&](FieldId id) { return fields.test(static_cast<std::size_t>(id)); });
}

} // namespace

Simulation::Simulation(const assets::Assets& assets)
    : lab_(&assets), assets_(&assets), spheres_(assets), triangles_(assets)
{
    restart_level();
    begin_event();
    set_up_particles();
}

Outcome Simulation::apply(const Command& command, double value)
{
    Outcome outcome = app::apply(state_, *assets_, command, value);
    if (outcome.refusal.empty()) {
        follow(outcome);
    }
    return outcome;
}

Outcome Simulation::apply(std::string_view name, double value)
{
    const Command* command = find_command(name);
    return command == nullptr ? Outcome::refused("There is no command " + base::in_quotes(name) + ".")
                              : apply(*command, value);
}

Outcome Simulation::step()
{
    const bool has_come_to_rest = motion_.step();
    Outcome outcome = app::step(state_, *assets_);
    follow(outcome);
    const bool is_counted = outcome.is_visible();
    outcome.animated = has_come_to_rest;
    meet(outcome);
    if (!is_counted && outcome.is_visible()) {
        ++revision_;
    }
    return outcome;
}

Outcome Simulation::set_user_tank(const assets::Assets* own)
{
    own_ = own;
    Outcome outcome;
    if (choose_tank()) {
        outcome.tank_replaced = true;
        ++revision_;
        update_report(false);
        if (state_.event.kind == EventKind::none) {
            begin_event();
        } else {
            replay();
        }
    }
    return outcome;
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
    LinkResult result = app::open_link(state_, fragment);
    if (result.outcome.opened) {
        follow(result.outcome);
    }
    return result;
}

/// Brings everything up to date after the state has changed, and adds what that brought about.
void Simulation::follow(Outcome& outcome)
{
    outcome.tank_replaced = choose_tank();
    const bool has_moved = spheres_.refit(state_) || outcome.tank_replaced;
    if (has_moved || outcome.opened || outcome.printed || any_of(outcome.fields, PROBE_FIELDS)) {
        update_report(outcome.printed);
    }
    if (outcome.opened) {
        restart_level();
        motion_.forget();
    } else {
        outcome.switched = update_level();
        motion_.follow(outcome.fields);
    }
    if (outcome.opened || any_of(outcome.fields, PARTICLE_FIELDS)) {
        set_up_particles();
    }
    if (outcome.is_visible()) {
        ++revision_;
    }
    if (outcome.opened) {
        replay();
    } else if (outcome.tank_replaced || outcome.fired) {
        begin_event();
    } else if (outcome.landed) {
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
    sparks_.extinguish(); // a link says all there is, and nothing of what was before it
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

void Simulation::restart_level()
{
    level_.start(eye_distance(state_), state_.show.threshold);
    level_switches_ = 0;
}

bool Simulation::update_level()
{
    const bool has_switched =
        level_.update(eye_distance(state_), lod::band_by_fraction(state_.show.threshold));
    level_switches_ += has_switched ? 1 : 0;
    return has_switched;
}

/// Lets the projectile meet the spheres on the way of this step, and the sparks fly.
void Simulation::meet(Outcome& outcome)
{
    const bool is_there = state_.shot.flies || state_.projectile.probe == Probe::point;
    const std::optional<glm::dvec3> position =
        is_there ? std::optional(projectile_position(state_)) : std::nullopt;
    contacts_.move(position, state_.projectile.radius, spheres_.hierarchy(),
                   [this, &outcome](std::size_t part, const glm::dvec3& place) {
                       outcome.hit = true;
                       ++touches_;
                       sparks_.burst(place);
                       log_.note("The projectile touches " +
                                 std::string(tank::part_name(static_cast<tank::Part>(part))) + " at " +
                                 base::in_metres(place) + ".");
                   });
    sparks_.shower(contacts_.inside().is_empty() ? std::nullopt : position);
    outcome.animated = outcome.animated || sparks_.is_active() || particles_.is_active();
    constexpr double SECONDS = 1.0 / TICKS_PER_SECOND;
    sparks_.step(SECONDS);
    particles_.step(SECONDS);
}

lod::Level Simulation::level() const
{
    return level_.level;
}

lod::Level Simulation::shown_level() const
{
    switch (state_.show.detail) {
    case Detail::automatic:
        return level();
    case Detail::low:
        return lod::Level::low;
    case Detail::high:
    case Detail::both:
        break;
    }
    return lod::Level::high;
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
