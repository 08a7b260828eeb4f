#include "app/simulation/simulation.h"
#include "checks/check_picture.h"
#include "checks/drawn_vertices.h"
#include "checks/lab_2_checks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>
#include <vector>

namespace checks {
namespace {

constexpr std::string_view TASK = "task=2.4";

/// What a person moves the point by.
struct Movement
{
    std::string_view command;
    glm::dvec3 way;
};

constexpr Movement MOVEMENTS[] = {
    {"projectile_right", {1, 0, 0}}, {"projectile_left", {-1, 0, 0}},  {"projectile_up", {0, 1, 0}},
    {"projectile_down", {0, -1, 0}}, {"projectile_nearer", {0, 0, 1}}, {"projectile_away", {0, 0, -1}},
};

bool has_key(std::string_view name)
{
    const app::Command* command = app::find_command(name);
    return command != nullptr && command->keys[0] != app::Key::none;
}

/// Moves the point by the key of a command for a few ticks; returns how far it came. Metres.
glm::dvec3 moved_by(app::Simulation& simulation, std::string_view command)
{
    const glm::dvec3 before = simulation.state().projectile.point;
    simulation.apply(command, 1.0);
    for (int tick = 0; tick < 12; ++tick) {
        simulation.step();
    }
    simulation.apply(command, 0.0);
    return simulation.state().projectile.point - before;
}

/// Returns how many vertices of faces are on a sphere about the place, and no larger one than a hand's.
std::size_t point_vertices(const std::vector<DrawnVertex>& vertices, const app::ProbeInFrame& probe)
{
    return static_cast<std::size_t>(
        std::count_if(vertices.begin(), vertices.end(), [&](const DrawnVertex& vertex) {
            return vertex.drawn == Drawn::faces &&
                   std::fabs(glm::distance(vertex.world, probe.point) - probe.point_radius) < 0.01;
        }));
}

void check_movement(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(TASK);
    std::string wrong;
    for (const Movement& movement : MOVEMENTS) {
        const glm::dvec3 way = moved_by(simulation, movement.command);
        const app::Frame frame = simulation.frame();
        const auto vertices = drawn_vertices(capture_frame(subject, frame), frame.camera);
        const double along = glm::dot(way, movement.way);
        const bool right = has_key(movement.command) && along > 0.05 &&
                           glm::length(way - along * movement.way) < 1e-9 &&
                           point_vertices(vertices, frame.probe) >= 20;
        wrong += right ? "" : " " + std::string(movement.command);
    }
    evidence.require(wrong.empty(),
                     "Six keys move the point along X, Y and Z, both ways, and it is drawn where it is.",
                     "These keys do not move the drawn point along their axis:" + wrong + ".");
}

/// Counts the vertices of faces on a penetrated sphere.
struct Look
{
    std::size_t transparent = 0; ///< blended, seen through, and hiding nothing by their depth
    std::size_t other = 0;       ///< a few of other things may happen to be there
};

Look look_of(const app::SphereInFrame& sphere, const std::vector<DrawnVertex>& vertices)
{
    Look look;
    for (const DrawnVertex& vertex : vertices) {
        if (vertex.drawn != Drawn::faces ||
            std::fabs(glm::distance(vertex.world, sphere.centre) - sphere.radius) > 2e-3 || vertex.textured) {
            continue;
        }
        const bool transparent =
            vertex.blended && !vertex.writes_depth && vertex.opacity > 0.0 && vertex.opacity < 0.9;
        ++(transparent ? look.transparent : look.other);
    }
    return look;
}

/// Places where the point penetrates one or more spheres.
constexpr std::string_view PLACES[] = {
    TASK,
    "task=2.4&point_x=0&point_y=2.4&point_z=0.4&turret=80",
    "task=2.4&heading=60&point_x=1.2&point_y=1.1&point_z=-1",
};

void check_spheres(const CheckSubject& subject, Evidence& evidence)
{
    std::size_t penetrated = 0;
    std::size_t wrong = 0;
    for (std::string_view place : PLACES) {
        app::Simulation simulation(subject.assets);
        simulation.open_link(place);
        const app::Frame frame = simulation.frame();
        const std::size_t reported = simulation.report().explanation.hits.count() + 1; // and the whole tank's
        const auto vertices = drawn_vertices(capture_frame(subject, frame), frame.camera);
        std::size_t right = 0;
        for (const app::SphereInFrame& sphere : frame.spheres) {
            const Look look = look_of(sphere, vertices);
            right += sphere.is_penetrated && look.transparent >= 100 && look.other * 20 < look.transparent
                         ? 1u
                         : 0u;
        }
        penetrated += reported;
        wrong += reported - std::min(right, reported);
    }
    evidence.require(wrong == 0,
                     "In three poses all " + std::to_string(penetrated) +
                         " penetrated spheres are drawn filled where they are, blended, without hiding what "
                         "is behind.",
                     std::to_string(wrong) + " of " + std::to_string(penetrated) +
                         " penetrated spheres are not drawn filled, blended and without depth where they "
                         "are.");
}

/// The spheres must show in the picture, and the tank through them: turning it then still changes the
/// picture.
void check_picture(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(TASK);
    const auto with = picture_of(subject, simulation.frame());
    simulation.apply("spheres", 0.0);
    const double shown = share_of_other_pixels(with, picture_of(subject, simulation.frame()));
    simulation.open_link(TASK);
    simulation.apply("parts", 1.0); // the body alone; the spheres stay those of the penetrated parts
    const double through = share_of_other_pixels(with, picture_of(subject, simulation.frame()));
    evidence.require(shown > 0.03 && through > 0.01,
                     "The spheres cover " + std::to_string(std::lround(shown * 100.0)) +
                         " % of the picture, and the tank is seen through them.",
                     shown > 0.03 ? "The tank is not seen through the spheres."
                                  : "The penetrated spheres do not show in the picture.");
}

} // namespace

void check_point_shown(const CheckSubject& subject, Evidence& evidence)
{
    check_movement(subject, evidence);
    check_spheres(subject, evidence);
    check_picture(subject, evidence);
}

} // namespace checks
