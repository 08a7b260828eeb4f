#include "assets/winding.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace assets {

namespace {

glm::dvec3 unit(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : vector;
}

bool winds_against_normals(const mesh::ObjMesh& mesh, const mesh::Face& face)
{
    const auto position = [&](std::size_t i) {
        return glm::dvec3(mesh.positions[static_cast<std::size_t>(face.vertices[i].position)]);
    };
    glm::dvec3 normal(0.0); // of whatever lengths they are, each corner's counts as much
    for (const mesh::FaceVertex& corner : face.vertices) {
        normal += unit(mesh.normals[static_cast<std::size_t>(corner.normal)]);
    }
    return glm::dot(glm::cross(position(1) - position(0), position(2) - position(0)), normal) < 0.0;
}

} // namespace

void wind_by_normals(std::span<mesh::ObjMesh> meshes)
{
    for (mesh::ObjMesh& mesh : meshes) {
        for (mesh::Face& face : mesh.faces) {
            if (winds_against_normals(mesh, face)) {
                std::swap(face.vertices[1], face.vertices[2]);
            }
        }
    }
}

} // namespace assets
