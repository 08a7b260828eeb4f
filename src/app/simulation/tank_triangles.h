#pragma once

#include "assets/assets.h"
#include "collision/triangle_mesh.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace app {

/// Says how a point was tested against the triangles of a part: the level below its sphere. Metres, in the
/// world.
struct TriangleTest
{
    tank::Part part;
    std::array<glm::dvec3, 3> corners; ///< of the nearest triangle
    glm::dvec3 point;                  ///< of it, nearest to the tested one
    double distance;                   ///< from there
    bool is_inside;                    ///< the tested point is inside the mesh
};

/// Holds the triangles of the high model's meshes, to be tested where a point is inside a part's sphere.
class TankTriangles
{
public:
    explicit TankTriangles(const assets::Assets& assets);

    /// Tests a point against a part, whose mesh the matrix takes to the world. Nothing for a mesh without
    /// triangles or a point that is not finite. Precondition: the matrix is rigid.
    std::optional<TriangleTest> test(const glm::dvec3& point, tank::Part part, const glm::mat4& matrix) const;

private:
    const assets::Assets* assets_;
    std::array<std::vector<collision::Triangle>, tank::MESH_KIND_COUNT> triangles_;
};

} // namespace app
