#include "app/simulation/simulation.h"
#include "base/measures.h"
#include "checks/check_text.h"
#include "checks/drawn_vertices.h"
#include "checks/lab_2_checks.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string_view>

namespace checks {
namespace {

using collision::BoundingSphere;
using tank::Part;

constexpr double TOLERANCE = 2e-3; // metres; the modelview matrices are floats, the eye 20 m away

constexpr std::string_view POSES[] = {
    "spheres=all",
    "spheres=all&turret=70&gun=15&secondary_gun=-60&wheels=40&heading=25",
    "spheres=all&x=6&z=-3&heading=-140&turret=-110&gun=-5&wheels_left=-80&fit=smallest",
};

/// Returns, of each part, how far its drawn vertices reach out of its sphere. Metres; negative: all inside.
std::array<double, tank::PART_COUNT> overhang(const CheckSubject& subject, const app::Simulation& simulation,
                                              const FrameCapture& capture)
{
    std::array<double, tank::PART_COUNT> out;
    out.fill(1e9); // what is not drawn where it should be is outside of everything
    const app::CameraView& camera = simulation.frame().camera;
    const glm::dmat4 to_world = glm::inverse(glm::lookAt(camera.eye, camera.centre, camera.up));
    const PartCalls calls = find_part_calls(subject, capture, simulation.state());
    for (Part part : tank::ALL_PARTS) {
        if (!calls[tank::index_of(part)]) {
            continue;
        }
        const std::size_t call = *calls[tank::index_of(part)];
        const glm::dmat4 matrix = to_world * glm::dmat4(capture.tank_list_calls[call].modelview);
        const BoundingSphere& sphere = simulation.spheres().hierarchy().parts()[tank::index_of(part)];
        double furthest = -sphere.radius;
        for (const LegacyGLCall& of_list : capture.calls_of_list(capture.tank_list_calls[call])) {
            if (std::string_view(of_list.name).starts_with("glVertex")) {
                const glm::dvec4 vertex(of_list.arguments[0], of_list.arguments[1], of_list.arguments[2], 1);
                furthest = std::max(furthest, glm::distance(glm::dvec3(matrix * vertex), sphere.centre) -
                                                  sphere.radius);
            }
        }
        out[tank::index_of(part)] = furthest;
    }
    return out;
}

/// Returns the parts whose spheres do not follow them: a vertex is outside, or the sphere far too wide.
PartSet not_enclosed(const CheckSubject& subject, const app::Simulation& simulation,
                     const FrameCapture& capture)
{
    const auto out = overhang(subject, simulation, capture);
    PartSet parts;
    for (Part part : tank::ALL_PARTS) {
        // Both ways of computing a sphere let it touch a vertex.
        parts[tank::index_of(part)] = !(std::fabs(out[tank::index_of(part)]) <= TOLERANCE);
    }
    return parts;
}

/// Returns by how much the widest part's sphere reaches out of the root; the least of a right root is 0.
double root_overhang(const collision::SphereHierarchy& spheres)
{
    double most = -1e9;
    for (const BoundingSphere& part : spheres.parts()) {
        most = std::max(most, glm::distance(part.centre, spheres.root().centre) + part.radius -
                                  spheres.root().radius);
    }
    return most;
}

/// Returns of how many of the frame's spheres the wire is drawn where they are.
std::size_t drawn_spheres(const app::Frame& frame, const std::vector<DrawnVertex>& vertices)
{
    std::size_t drawn = 0;
    for (const app::SphereInFrame& sphere : frame.spheres) {
        std::size_t on_sphere = 0;
        for (const DrawnVertex& vertex : vertices) {
            on_sphere += vertex.drawn == Drawn::lines &&
                                 std::fabs(glm::distance(vertex.world, sphere.centre) - sphere.radius) <
                                     TOLERANCE * 2.0
                             ? 1u
                             : 0u;
        }
        drawn += on_sphere >= 50 ? 1u : 0u;
    }
    return drawn;
}

void check_pose(const CheckSubject& subject, std::string_view link, Evidence& evidence)
{
    // Moved by commands from the pose before, so that spheres that stay behind are found.
    app::Simulation simulation(subject.assets);
    static_cast<void>(simulation.frame());
    simulation.open_link(link);
    const app::Frame frame = simulation.frame();
    const FrameCapture capture = capture_frame(subject, frame);
    const collision::SphereHierarchy& spheres = simulation.spheres().hierarchy();
    const std::string pose = "In the pose " + std::string(link) + " ";

    const PartSet wrong = not_enclosed(subject, simulation, capture);
    evidence.require(
        wrong.none() && spheres.part_count() == tank::PART_COUNT,
        pose + "each of the 18 spheres encloses all vertices drawn of its part, and touches one.",
        pose + "these spheres are not around what is drawn of their parts: " + named(wrong) + ".");
    const double root = root_overhang(spheres);
    evidence.require(std::fabs(root) <= TOLERANCE,
                     pose + "the whole tank's sphere, radius " + base::in_metres(spheres.root().radius) +
                         " m, is the tightest around these.",
                     pose + "a part's sphere reaches " + base::in_metres(root) +
                         " m out of the whole tank's sphere.");
    const std::size_t drawn = drawn_spheres(frame, drawn_vertices(capture, frame.camera));
    evidence.require(drawn == tank::PART_COUNT + 1, pose + "all 19 spheres are drawn as wire where they are.",
                     pose + std::to_string(drawn) + " of 19 spheres are drawn as wire where they are.");
}

/// Only what moves has its sphere recomputed.
void check_refitting(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    const collision::RefitCounts before = simulation.spheres().hierarchy().refit_counts();
    simulation.apply("secondary_gun_left", 1.0);
    simulation.step();
    simulation.apply("secondary_gun_left", 0.0);
    const collision::RefitCounts turned = simulation.spheres().hierarchy().refit_counts();
    for (int tick = 0; tick < 10; ++tick) {
        simulation.apply("orbit_by", 3.0);
        simulation.step();
    }
    const collision::RefitCounts after = simulation.spheres().hierarchy().refit_counts();
    evidence.require(turned.parts - before.parts == 1 && turned.roots - before.roots == 1 &&
                         after.parts == turned.parts && after.roots == turned.roots,
                     "Turning the secondary gun recomputes its sphere and the whole tank's, going round "
                     "the tank none.",
                     "Turning the secondary gun recomputes " + std::to_string(turned.parts - before.parts) +
                         " spheres of parts, going round the tank " +
                         std::to_string(after.parts - turned.parts) + ".");
}

} // namespace

void check_sphere_hierarchy(const CheckSubject& subject, Evidence& evidence)
{
    for (std::string_view pose : POSES) {
        check_pose(subject, pose, evidence);
    }
    check_refitting(subject, evidence);
}

} // namespace checks
