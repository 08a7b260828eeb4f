#include "app/simulation/simulation.h"
#include "checks/check_text.h"
#include "checks/drawn_vertices.h"
#include "checks/lab_2_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>

namespace checks {
namespace {

using app::Probe;
using tank::Part;

struct Kind
{
    std::string_view name;
    Probe probe;
    double first; ///< the least parameter of its points
    double last;
};

constexpr double ENDLESS = std::numeric_limits<double>::infinity();

constexpr Kind KINDS[] = {
    {"segment", Probe::segment, 0.0, 1.0},
    {"ray", Probe::ray, 0.0, ENDLESS},
    {"line", Probe::line, -ENDLESS, ENDLESS},
};

constexpr double TOLERANCE = 1e-6; // metres

/// Returns the point from a towards b that is closest to the centre, among those the kind has.
glm::dvec3 closest(const Kind& kind, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& centre)
{
    const glm::dvec3 way = b - a;
    const double length = glm::dot(way, way);
    const double parameter = length > 0.0 ? glm::dot(centre - a, way) / length : 0.0;
    return a + std::clamp(parameter, kind.first, kind.last) * way;
}

struct Counts
{
    std::size_t hits = 0;
    std::size_t wrong_hits = 0;
    std::size_t wrong_points = 0;
};

void count(const app::Simulation& simulation, const Kind& kind, Counts& counts)
{
    const app::Projectile& projectile = simulation.state().projectile;
    const app::HitReport& report = simulation.report();
    const collision::SphereHierarchy& spheres = simulation.spheres().hierarchy();
    for (Part part : tank::ALL_PARTS) {
        const std::size_t index = tank::index_of(part);
        const collision::BoundingSphere& sphere = spheres.parts()[index];
        const glm::dvec3 point = closest(kind, projectile.a, projectile.b, sphere.centre);
        const double distance = glm::distance(point, sphere.centre);
        const bool inside = distance <= sphere.radius;
        const bool is_clear = std::fabs(distance - sphere.radius) > TOLERANCE;
        const bool reported = report.explanation.hits.contains(index);
        counts.hits += inside ? 1u : 0u;
        counts.wrong_hits += is_clear && reported != inside ? 1u : 0u;
        if (reported) {
            const collision::SphereTest& test = report.explanation.parts[index];
            counts.wrong_points += glm::distance(test.closest_point, point) <= 1e-5 ? 0u : 1u;
        }
    }
}

/// A number in [0, 1) that follows from a count; the same everywhere.
double scattered(std::uint32_t& state)
{
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 16777216.0;
}

void lay_line(app::Simulation& simulation, std::uint32_t& state)
{
    for (std::string_view name : {"line_ax", "line_az", "line_bx", "line_bz"}) {
        simulation.apply(name, 24.0 * scattered(state) - 12.0);
    }
    for (std::string_view name : {"line_ay", "line_by"}) {
        simulation.apply(name, 4.0 * scattered(state));
    }
}

void check_kind(const CheckSubject& subject, const Kind& kind, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link("turret=-35&gun=12&heading=15");
    simulation.apply("probe", static_cast<double>(kind.probe));
    constexpr int LINES = 400;
    std::uint32_t state = 1;
    Counts counts;
    for (int i = 0; i < LINES; ++i) {
        lay_line(simulation, state);
        count(simulation, kind, counts);
    }
    const std::string name(kind.name);
    evidence.require(counts.wrong_hits == 0 && counts.hits > 50,
                     std::to_string(LINES) + " times a " + name + ": it penetrates " +
                         std::to_string(counts.hits) +
                         " spheres, exactly those that its points closest to the centres are inside of.",
                     std::to_string(counts.wrong_hits) + " spheres are answered otherwise than by the " +
                         name + "'s point closest to their centre.");
    evidence.require(counts.wrong_points == 0, "Each of these points is on the " + name + " and closest.",
                     std::to_string(counts.wrong_points) + " points reported are not the " + name +
                         "'s closest to the centre.");
}

/// Counts the vertices within a foot of a place: marks further from the eye are drawn larger.
std::size_t drawn_at(const std::vector<DrawnVertex>& vertices, const glm::dvec3& place)
{
    constexpr double FOOT = 0.3; // metres
    return static_cast<std::size_t>(
        std::count_if(vertices.begin(), vertices.end(),
                      [&](const DrawnVertex& vertex) { return glm::distance(vertex.world, place) < FOOT; }));
}

void check_drawn(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link("task=2.5");
    const app::Frame frame = simulation.frame();
    const auto with = drawn_vertices(capture_frame(subject, frame), frame.camera);
    simulation.apply("probe", static_cast<double>(Probe::none));
    const auto without = drawn_vertices(capture_frame(subject, simulation.frame()), frame.camera);
    std::size_t marked = 0;
    for (const app::ClosestPointInFrame& closest_point : frame.closest_points) {
        marked += drawn_at(with, closest_point.point) > drawn_at(without, closest_point.point) ? 1u : 0u;
    }
    const std::size_t wanted = simulation.frame().closest_points.size() + frame.closest_points.size();
    const bool ends = drawn_at(with, frame.probe.a) > drawn_at(without, frame.probe.a) &&
                      drawn_at(with, frame.probe.b) > drawn_at(without, frame.probe.b);
    evidence.require(marked == wanted && wanted >= 2 && ends,
                     "The line is drawn with both ends, and the " + std::to_string(marked) +
                         " points closest to the centres of penetrated spheres are marked.",
                     "Of " + std::to_string(wanted) + " closest points " + std::to_string(marked) +
                         " are marked" + (ends ? "." : "; the line's ends are not drawn."));
}

void check_ends_move(const CheckSubject& subject, Evidence& evidence)
{
    bool moved = true;
    for (const auto handle : {app::Handle::line_a, app::Handle::line_b}) {
        app::Simulation simulation(subject.assets);
        simulation.open_link("task=2.5");
        simulation.apply("handle", static_cast<double>(handle));
        const app::Projectile before = simulation.state().projectile;
        for (std::string_view command : {"projectile_right", "projectile_up", "projectile_nearer"}) {
            simulation.apply(command, 1.0);
            simulation.step();
            simulation.apply(command, 0.0);
        }
        const app::Projectile& after = simulation.state().projectile;
        const bool is_a = handle == app::Handle::line_a;
        const glm::dvec3 way = is_a ? after.a - before.a : after.b - before.b;
        moved = moved && way.x > 0.0 && way.y > 0.0 && way.z > 0.0 &&
                (is_a ? after.b == before.b : after.a == before.a);
    }
    evidence.require(moved, "Keys move either end along all three axes, the other one staying.",
                     "Keys do not move each end of the line by itself along all three axes.");
}

} // namespace

void check_line_test(const CheckSubject& subject, Evidence& evidence)
{
    for (const Kind& kind : KINDS) {
        check_kind(subject, kind, evidence);
    }
    check_drawn(subject, evidence);
    check_ends_move(subject, evidence);
}

} // namespace checks
