#include "app/simulation/simulation.h"
#include "base/measures.h"
#include "checks/drawn_vertices.h"
#include "checks/lab_2_checks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace checks {
namespace {

using app::SphereFit;
using collision::BoundingSphere;

constexpr double TOLERANCE = 1e-4; // metres; positions are floats

/// Computes the lab's sphere once more, straight from its text.
BoundingSphere average_sphere(const mesh::ObjMesh& obj)
{
    glm::dvec3 sum(0.0);
    for (const glm::vec3& position : obj.positions) {
        sum += glm::dvec3(position);
    }
    BoundingSphere sphere{sum / static_cast<double>(obj.positions.size()), 0.0};
    for (const glm::vec3& position : obj.positions) {
        sphere.radius = std::max(sphere.radius, glm::distance(sphere.centre, glm::dvec3(position)));
    }
    return sphere;
}

std::size_t vertices_outside(const mesh::ObjMesh& obj, const BoundingSphere& sphere)
{
    return static_cast<std::size_t>(
        std::count_if(obj.positions.begin(), obj.positions.end(), [&](const glm::vec3& position) {
            return !(glm::distance(glm::dvec3(position), sphere.centre) <= sphere.radius + TOLERANCE);
        }));
}

void check_mesh(const CheckSubject& subject, const app::TankSpheres& spheres, std::size_t mesh,
                Evidence& evidence)
{
    const auto kind = static_cast<tank::MeshKind>(mesh);
    const mesh::ObjMesh& obj = subject.assets.high[mesh];
    const BoundingSphere wanted = average_sphere(obj);
    const BoundingSphere& average = spheres.of_mesh(kind, SphereFit::average);
    const BoundingSphere& smallest = spheres.of_mesh(kind, SphereFit::smallest);
    const std::string name = "the " + std::string(tank::mesh_title(kind));
    const bool is_average = glm::distance(average.centre, wanted.centre) <= TOLERANCE &&
                            std::fabs(average.radius - wanted.radius) <= TOLERANCE;
    evidence.require(is_average,
                     "The sphere of " + name + " is around the average of its " +
                         std::to_string(obj.positions.size()) +
                         " vertices and reaches the furthest one: " + base::in_metres(average.radius) + " m.",
                     "The sphere of " + name + " has its centre at " + base::in_metres(average.centre) +
                         " and a radius of " + base::in_metres(average.radius) + " m, but the average is " +
                         base::in_metres(wanted.centre) + " and the furthest vertex " +
                         base::in_metres(wanted.radius) + " m away.");
    const std::size_t outside = vertices_outside(obj, average) + vertices_outside(obj, smallest);
    evidence.require(
        outside == 0 && smallest.radius <= average.radius + TOLERANCE,
        "No vertex is outside of it or of the smallest sphere, " + base::in_metres(smallest.radius) + " m.",
        std::to_string(outside) + " vertices of " + name + " are outside of its spheres of " +
            base::in_metres(average.radius) + " m and " + base::in_metres(smallest.radius) + " m.");
}

/// Both ways of computing must show: the vertices of the body's drawn sphere are where the sphere is.
void check_drawn(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link("task=2.1");
    const app::Frame frame = simulation.frame();
    const FrameCapture capture = capture_frame(subject, frame);
    std::size_t on_sphere = 0;
    if (frame.spheres.size() == 1) {
        const app::SphereInFrame& sphere = frame.spheres[0];
        for (const DrawnVertex& vertex : drawn_vertices(capture, frame.camera)) {
            const double distance = glm::distance(vertex.world, sphere.centre);
            on_sphere += vertex.drawn == Drawn::lines && std::fabs(distance - sphere.radius) < 0.01 ? 1u : 0u;
        }
    }
    evidence.require(on_sphere >= 100,
                     "The body's sphere is drawn around it as wire, its vertices on the sphere.",
                     "Where the body's sphere is, only " + std::to_string(on_sphere) +
                         " vertices of a wire sphere are drawn.");
}

} // namespace

void check_mesh_spheres(const CheckSubject& subject, Evidence& evidence)
{
    const app::TankSpheres spheres(subject.assets);
    for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
        check_mesh(subject, spheres, mesh, evidence);
    }
    check_drawn(subject, evidence);
}

} // namespace checks
