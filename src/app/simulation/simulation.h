#pragma once

#include "app/commands/commands.h"
#include "app/links/links.h"
#include "app/simulation/contacts.h"
#include "app/simulation/hit_log.h"
#include "app/simulation/hit_report.h"
#include "app/simulation/motion.h"
#include "app/simulation/sparks.h"
#include "app/simulation/tank_spheres.h"
#include "app/state/outcome.h"
#include "app/state/state.h"
#include "app/view/frame.h"
#include "assets/assets.h"
#include "lod/level_selector.h"
#include "particles/particle_system.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace app {

/// The running program without window and GL: the state and what follows from it. The state goes its way by
/// commands, steps and links alone; here is what it meets there. Everything the state does not say by
/// itself, such as where the spheres are, is here and brought up to date by each call.
/// Not for several threads at once. A step in which nothing moves allocates nothing.
class Simulation
{
public:
    /// Begins in the default state. `assets` must outlive this.
    explicit Simulation(const assets::Assets& assets);

    /// Executes a command and returns what happened: see app::apply().
    Outcome apply(const Command& command, double value);
    Outcome apply(std::string_view name, double value);

    /// Advances by one tick and returns what happened: see app::step().
    Outcome step();

    /// Takes the tank that the user brought, or none, in place of the one before; the state that asks for it
    /// gets it, and what a link has under way is replayed with it. `own` must outlive this.
    Outcome set_user_tank(const assets::Assets* own);

    /// Opens a fragment: see app::open_link(). What a link has under way is replayed.
    LinkResult open_link(std::string_view fragment);

    /// Counts the changes that people could see so far, for whoever shows them.
    std::uint64_t revision() const { return revision_; }

    const State& state() const { return state_; }

    /// Returns the data of the tank that is shown.
    const assets::Assets& assets() const { return *assets_; }

    /// Returns whether the user has brought a tank, and whether the state asks for one that is not there.
    bool has_own_tank() const { return own_ != nullptr; }
    bool lacks_own_tank() const { return state_.tank == TankShown::own && own_ == nullptr; }

    const TankSpheres& spheres() const { return spheres_; }

    /// Returns how the probe was tested, as it is now.
    const HitReport& report() const { return report_; }
    const HitLog& log() const { return log_; }

    /// Returns the parts whose spheres the projectile is inside of: in flight, or at rest when it is tested.
    collision::PartSet inside() const { return contacts_.inside(); }

    /// Returns how many times the projectile has touched a part's sphere since the last opening or firing.
    std::uint64_t touches() const { return touches_; }

    const Sparks& sparks() const { return sparks_; }
    const particles::ParticleSystem& shown_particles() const { return particles_; }

    /// Returns the parts whose joints move right now: see Motion::parts().
    collision::PartSet moving_parts() const { return motion_.parts(assets_->layout); }

    /// Returns the level of the tank that is drawn; of both side by side, the first one's.
    lod::Level shown_level() const;

    /// Returns the level by distance, with its memory, and how often it has switched since the last opening.
    lod::Level level() const;
    std::uint64_t level_switches() const { return level_switches_; }

    /// Returns the 64-bit FNV-1a hash of the state, of what the projectile is inside of and of the sparks
    /// and particles since the event: the same on every machine after the same commands, and after opening a
    /// link of what is under way.
    std::uint64_t hash() const;

    /// Returns what is to be drawn. Views of particles in it last until this is next changed.
    Frame frame() const;

private:
    void follow(Outcome& outcome);
    bool choose_tank();
    void replay();
    void begin_event();
    void set_up_particles();
    void restart_level();
    bool update_level();
    void meet(Outcome& outcome);
    void update_report(bool is_asked);

    const assets::Assets* lab_;
    const assets::Assets* own_ = nullptr;
    const assets::Assets* assets_; ///< one of the two
    State state_;
    TankSpheres spheres_;
    TankTriangles triangles_;
    HitReport report_;
    HitLog log_;
    Contacts contacts_;
    Sparks sparks_;
    particles::ParticleSystem particles_; ///< the preset that is shown
    std::uint64_t touches_ = 0;
    Motion motion_;
    lod::LevelSelector level_;
    std::uint64_t level_switches_ = 0;
    std::uint64_t revision_ = 0;
};

} // namespace app
