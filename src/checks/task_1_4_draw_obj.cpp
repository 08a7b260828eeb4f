#include "checks/lab_1_checks.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace checks {
namespace {

constexpr double TRIANGLES = 4.0; // GL_TRIANGLES; <GL/gl.h> is scene's alone

/// Compares what a list drew with the mesh, one call after the other.
class Comparison
{
public:
    /// faces: of obj, in the order in which they have to come.
    Comparison(const mesh::ObjMesh& obj, std::span<const int> faces) : obj_(obj), faces_(faces) {}

    void take(const LegacyGLCall& call)
    {
        const std::string_view name = call.name;
        if (name == "glBegin") {
            only_triangles_ = only_triangles_ && call.arguments[0] == TRIANGLES;
        } else if (name.starts_with("glNormal")) {
            normal_ = {call.arguments[0], call.arguments[1], call.arguments[2]};
        } else if (name.starts_with("glTexCoord")) {
            texture_coordinate_ = {call.arguments[0], call.arguments[1]};
        } else if (name.starts_with("glVertex")) {
            take_corner({call.arguments[0], call.arguments[1], call.arguments[2]});
        }
    }

    bool only_triangles() const { return only_triangles_; }
    std::size_t corners() const { return corners_; }
    std::size_t wrong_corners() const { return wrong_corners_; }

private:
    void take_corner(const glm::dvec3& position)
    {
        const std::size_t corner = corners_++;
        if (corner / 3 >= faces_.size()) {
            return; // too many, which the count shows
        }
        const mesh::FaceVertex& wanted =
            obj_.faces[static_cast<std::size_t>(faces_[corner / 3])].vertices[corner % 3];
        const bool textured = wanted.texture_coordinate >= 0;
        const glm::dvec2 texture_coordinate =
            textured
                ? glm::dvec2(obj_.texture_coordinates[static_cast<std::size_t>(wanted.texture_coordinate)])
                : glm::dvec2(0.0);
        const bool right =
            position == glm::dvec3(obj_.positions[static_cast<std::size_t>(wanted.position)]) &&
            normal_ == glm::dvec3(obj_.normals[static_cast<std::size_t>(wanted.normal)]) &&
            texture_coordinate_ == texture_coordinate;
        wrong_corners_ += right ? 0u : 1u;
    }

    const mesh::ObjMesh& obj_;
    std::span<const int> faces_;
    bool only_triangles_ = true;
    std::size_t corners_ = 0;
    std::size_t wrong_corners_ = 0;
    glm::dvec3 normal_{0.0};
    glm::dvec2 texture_coordinate_{0.0};
};

/// Returns the faces of a mesh in the order of its drawing: a body's links come after the rest of it, the
/// left track's first.
std::vector<int> drawing_order(const assets::Assets& assets, std::size_t mesh)
{
    std::vector<int> order(assets.high[mesh].faces.size());
    std::iota(order.begin(), order.end(), 0);
    if (mesh == tank::index_of(tank::MeshKind::body) && assets.track_links.any()) {
        order = assets.track_links.resting;
        for (const auto& side : assets.track_links.moving) {
            for (const assets::LinkFace& face : side) {
                order.push_back(face.here);
            }
        }
    }
    return order;
}

void check_mesh(const CheckSubject& subject, const FrameCapture& capture, std::size_t call,
                Evidence& evidence)
{
    const std::size_t mesh = tank::index_of(capture.tank_list_calls[call].mesh);
    const mesh::ObjMesh& obj = subject.assets.high[mesh];
    const std::vector<int> order = drawing_order(subject.assets, mesh);
    Comparison comparison(obj, order);
    for (const LegacyGLCall& of_list : capture.calls_of_list(capture.tank_list_calls[call])) {
        comparison.take(of_list);
    }
    const std::string name(tank::mesh_title(static_cast<tank::MeshKind>(mesh)));
    const std::string faces = std::to_string(obj.faces.size());
    evidence.require(comparison.only_triangles() && comparison.corners() == obj.faces.size() * 3 &&
                         comparison.wrong_corners() == 0,
                     "The list of the " + name + " gives the three corners of its " + faces +
                         " faces within glBegin(GL_TRIANGLES), each with the position, normal and texture "
                         "coordinate that its three indices name.",
                     "The list of the " + name + " gives " + std::to_string(comparison.corners()) +
                         " corners for its " + faces + " faces, " +
                         std::to_string(comparison.wrong_corners()) + " of them not what their indices name" +
                         (comparison.only_triangles() ? "." : ", and not all as GL_TRIANGLES."));
}

} // namespace

void check_draw_obj(const CheckSubject& subject, Evidence& evidence)
{
    const FrameCapture capture = capture_frame(subject, app::State{});
    for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
        std::size_t call = 0;
        while (call < capture.tank_list_calls.size() &&
               tank::index_of(capture.tank_list_calls[call].mesh) != mesh) {
            ++call;
        }
        if (call == capture.tank_list_calls.size()) {
            evidence.require(false, "",
                             "No list draws the " +
                                 std::string(tank::mesh_title(static_cast<tank::MeshKind>(mesh))) + ".");
        } else {
            check_mesh(subject, capture, call, evidence);
        }
    }
}

} // namespace checks
