// What Simulation adds to the frame of its state.
#include "app/simulation/simulation.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace app {

namespace {

/// Wires are drawn of what is drawn itself; what is penetrated always shows.
bool is_drawn(SpheresShown shown, bool is_root, bool is_penetrated, bool is_part_drawn)
{
    if (!is_root && !is_part_drawn && !is_penetrated) {
        return false;
    }
    switch (shown) {
    case SpheresShown::off:
        return false;
    case SpheresShown::penetrated:
        return is_penetrated;
    case SpheresShown::whole:
        return is_root || is_penetrated;
    case SpheresShown::parts:
        return !is_root || is_penetrated;
    case SpheresShown::all:
        return true;
    }
    return false;
}

void add_sphere(Frame& frame, SpheresShown shown, const SphereInFrame& sphere)
{
    if (sphere.radius >= 0.0 &&
        is_drawn(shown, sphere.is_root, sphere.is_penetrated, frame.parts.contains(index_of(sphere.part)))) {
        frame.spheres.push_back(sphere);
    }
}

void add_particles(Frame& frame, const particles::ParticleSystem& system)
{
    if (system.live() > 0) {
        frame.particles.push_back(system.view());
    }
}

} // namespace

Frame Simulation::frame() const
{
    Frame frame = make_frame(state_, *assets_);
    if (state_.show.detail == Detail::automatic) {
        frame.tanks[0].level = level();
    }
    if (const std::optional<tank::Joint> joint = motion_.foremost(assets_->layout);
        joint && state_.show.axis == AxisShown::moving) {
        frame.axis = axis_of(state_, *assets_, *joint);
    }
    for (const particles::ParticleSystem* system : sparks_.systems()) {
        add_particles(frame, *system);
    }
    add_particles(frame, particles_);
    const collision::SphereHierarchy& spheres = spheres_.hierarchy();
    const collision::Explanation& explanation = report_.explanation;
    const SpheresShown shown = state_.show.spheres;
    add_sphere(frame, shown,
               {.centre = spheres.root().centre,
                .radius = spheres.root().radius,
                .is_root = true,
                .part = tank::Part::body,
                .is_penetrated = explanation.root.is_inside || !contacts_.inside().is_empty()});
    for (tank::Part part : tank::ALL_PARTS) {
        const collision::BoundingSphere& sphere = spheres.parts()[tank::index_of(part)];
        add_sphere(frame, shown,
                   {.centre = sphere.centre,
                    .radius = sphere.radius,
                    .is_root = false,
                    .part = part,
                    .is_penetrated = explanation.hits.contains(tank::index_of(part)) ||
                                     contacts_.inside().contains(tank::index_of(part))});
    }
    std::sort(frame.spheres.begin(), frame.spheres.end(),
              [eye = frame.camera.eye](const SphereInFrame& one, const SphereInFrame& other) {
                  const double to_one = glm::distance(one.centre, eye);
                  const double to_other = glm::distance(other.centre, eye);
                  // Of equally far ones the outer comes first, then the table's order: always the same
                  // picture.
                  return to_one != to_other             ? to_one > to_other
                         : one.is_root != other.is_root ? one.is_root
                                                        : one.part < other.part;
              });
    if (explanation.root.is_inside) {
        frame.closest_points.push_back(
            {explanation.root.closest_point, explanation.root.sphere.centre, true});
    }
    explanation.hits.for_each([&](std::size_t part) {
        const collision::SphereTest& test = explanation.parts[part];
        frame.closest_points.push_back({test.closest_point, test.sphere.centre, false});
    });
    for (const TriangleTest& test : report_.triangles) {
        frame.triangles.push_back({test.corners, test.point, test.is_inside});
    }
    return frame;
}

} // namespace app
