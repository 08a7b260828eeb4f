#include "app/simulation/tank_triangles.h"

#include <glm/matrix.hpp>

namespace app {

TankTriangles::TankTriangles(const assets::Assets& assets) : assets_(&assets)
{
    for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
        const mesh::ObjMesh& from = assets.high[mesh];
        triangles_[mesh].reserve(from.faces.size());
        for (const mesh::Face& face : from.faces) {
            const auto corner = [&](std::size_t i) {
                return from.positions[static_cast<std::size_t>(face.vertices[i].position)];
            };
            triangles_[mesh].push_back({corner(0), corner(1), corner(2)});
        }
    }
}

std::optional<TriangleTest> TankTriangles::test(const glm::dvec3& point, tank::Part part,
                                                const glm::mat4& matrix) const
{
    const std::vector<collision::Triangle>& triangles =
        triangles_[tank::index_of(assets_->layout[part].mesh)];
    const glm::dmat4 to_world(matrix);
    const auto in_world = [&](const glm::dvec3& p) { return glm::dvec3(to_world * glm::dvec4(p, 1.0)); };
    const glm::dvec3 local(glm::inverse(to_world) * glm::dvec4(point, 1.0));
    const std::optional<collision::NearestTriangle> nearest = collision::nearest_triangle(local, triangles);
    if (!nearest) {
        return std::nullopt;
    }
    const collision::Triangle& triangle = triangles[nearest->triangle];
    return TriangleTest{
        .part = part,
        .corners = {in_world(triangle.a), in_world(triangle.b), in_world(triangle.c)},
        .point = in_world(nearest->point),
        .distance = nearest->distance,
        .is_inside = collision::is_point_inside_mesh(local, triangles),
    };
}

} // namespace app
