#include "app/simulation/simulation.h"
#include "checks/check_text.h"
#include "checks/lab_2_checks.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

namespace checks {
namespace {

using app::HitReport;
using tank::Part;

constexpr std::string_view POSE = "turret=50&gun=10&secondary_gun=-30&heading=20&probe=point";

void place(app::Simulation& simulation, const glm::dvec3& point)
{
    simulation.apply("point_x", point.x);
    simulation.apply("point_y", point.y);
    simulation.apply("point_z", point.z);
}

/// Tests the state's point against all spheres, one after the other, by the text of the lab.
PartSet penetrated(const app::Simulation& simulation)
{
    PartSet parts;
    for (Part part : tank::ALL_PARTS) {
        const collision::BoundingSphere& sphere =
            simulation.spheres().hierarchy().parts()[tank::index_of(part)];
        parts[tank::index_of(part)] =
            glm::distance(simulation.state().projectile.point, sphere.centre) <= sphere.radius;
    }
    return parts;
}

PartSet reported(const HitReport& report)
{
    return {report.explanation.hits.bits()};
}

/// Counts what a walk of the point through and around the tank gives.
struct Counts
{
    std::size_t points = 0;
    std::size_t outside = 0; ///< of the whole tank's sphere
    std::size_t hits = 0;
    std::size_t wrong = 0;         ///< answers
    std::size_t wrong_order = 0;   ///< parts tested although the point is outside, or not all when inside
    std::size_t wrong_details = 0; ///< distance and depth that do not fit the sphere
};

void count(const app::Simulation& simulation, Counts& counts)
{
    const HitReport& report = simulation.report();
    const PartSet wanted = penetrated(simulation);
    ++counts.points;
    counts.hits += wanted.any() ? 1u : 0u;
    counts.wrong += reported(report) == wanted ? 0u : 1u;
    const collision::SphereTest& root = report.explanation.root;
    const bool inside =
        glm::distance(simulation.state().projectile.point, root.sphere.centre) <= root.sphere.radius;
    counts.outside += inside ? 0u : 1u;
    const std::size_t tested = report.explanation.parts.size();
    counts.wrong_order += root.is_inside == inside && tested == (inside ? tank::PART_COUNT : 0u) ? 0u : 1u;
    for (const collision::SphereTest& test : report.explanation.parts) {
        const double distance = glm::distance(simulation.state().projectile.point, test.sphere.centre);
        counts.wrong_details += std::abs(test.distance - distance) <= 1e-6 &&
                                        std::abs(test.depth - (test.sphere.radius - distance)) <= 1e-6
                                    ? 0u
                                    : 1u;
    }
}

void check_answers(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(POSE);
    Counts counts;
    for (double x = -6.0; x <= 6.0; x += 1.2) {
        for (double y = 0.1; y <= 6.0; y += 0.6) {
            for (double z = -7.0; z <= 9.0; z += 1.1) {
                place(simulation, {x, y, z});
                count(simulation, counts);
            }
        }
    }
    evidence.require(counts.wrong == 0 && counts.hits > 100 && counts.outside > 100,
                     "Of " + std::to_string(counts.points) + " points " + std::to_string(counts.hits) +
                         " penetrate spheres of parts, and exactly those that a test of all spheres finds.",
                     "Of " + std::to_string(counts.points) + " points " + std::to_string(counts.wrong) +
                         " are answered otherwise than by a test of all spheres.");
    evidence.require(counts.wrong_order == 0,
                     "The whole tank's sphere is tested first: for the " + std::to_string(counts.outside) +
                         " points outside of it no part is tested, for the others all 18.",
                     "For " + std::to_string(counts.wrong_order) +
                         " points the parts are tested though the whole is missed, or not all of them.");
    evidence.require(counts.wrong_details == 0, "Distances and depths are those to the centres.",
                     std::to_string(counts.wrong_details) + " distances or depths are wrong.");
}

/// Counts the lines after the first `from` that name a part.
std::size_t lines_about(const app::HitLog& log, std::uint64_t after, std::string_view text)
{
    std::size_t lines = 0;
    for (const app::LogLine& line : log.lines()) {
        lines += line.report > after && line.text.find(text) != std::string::npos ? 1u : 0u;
    }
    return lines;
}

void check_printing(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link("probe=point&point_x=0&point_y=1.2&point_z=0");
    const app::HitLog& log = simulation.log();
    const std::size_t hits = reported(simulation.report()).count();
    evidence.require(hits > 0 && lines_about(log, 0, "It penetrates ") == hits &&
                         lines_about(log, 0, "It penetrates body: centre ") == 1,
                     "Opening the link printed what the point penetrates: " + std::to_string(hits) +
                         " spheres, with centre, radius, distance and depth.",
                     "Opening the link did not print the " + std::to_string(hits) +
                         " spheres that the point penetrates.");

    const std::uint64_t opened = log.count();
    for (int tick = 0; tick < 30; ++tick) {
        simulation.step();
    }
    const bool quiet = log.count() == opened;
    simulation.apply("projectile_up", 1.0);
    simulation.step();
    simulation.apply("projectile_up", 0.0);
    const bool on_change = log.count() == opened + 1;
    simulation.apply("print_report", 1.0);
    const bool by_key = log.count() == opened + 2;
    evidence.require(quiet && on_change && by_key,
                     "Nothing is printed while nothing changes; one report when the point moves, one by the "
                     "key.",
                     std::string("Printing is not by change and key:") +
                         (quiet ? "" : " it prints though nothing changes;") +
                         (on_change ? "" : " moving the point does not print one report;") +
                         (by_key ? "" : " the key does not print one report;"));
    bool twice = false;
    for (std::size_t i = 1; i < log.lines().size(); ++i) {
        twice = twice || log.lines()[i].text == log.lines()[i - 1].text;
    }
    evidence.require(!twice, "No line is printed twice in a row.", "A line is printed twice in a row.");
}

} // namespace

void check_point_test(const CheckSubject& subject, Evidence& evidence)
{
    check_answers(subject, evidence);
    check_printing(subject, evidence);
}

} // namespace checks
