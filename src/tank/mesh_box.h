#pragma once

#include "tank/part.h"

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

namespace tank {

/// The smallest box along the axes that holds a mesh, in the mesh's own coordinates and units.
struct Box
{
    glm::vec3 minimum;
    glm::vec3 maximum;
};

/// Holds the box of each of the five meshes, by index_of(MeshKind).
using MeshBoxes = std::array<Box, MESH_KIND_COUNT>;

/// Returns the box of a kind of mesh.
constexpr const Box& box_of(const MeshBoxes& boxes, MeshKind mesh)
{
    return boxes[index_of(mesh)];
}

/// Returns the length of the box along Z, the direction of the gun.
constexpr double length_of(const Box& box)
{
    return static_cast<double>(box.maximum.z) - static_cast<double>(box.minimum.z);
}

/// Tells whether the boxes are the known ones in any unit: with both hulls scaled to one length, no side is
/// off by more than a hundredth of that length. A hull without length resembles nothing.
bool resembles(const MeshBoxes& boxes, const MeshBoxes& known);

/// Tells how high the turret's mesh reaches at (x, z), in its own coordinates: where a gun can stand on it.
/// Nothing where there is no turret, neither above nor below.
using TurretRoof = std::function<std::optional<float>(float x, float z)>;

/// Returns the height of the roof at (x, z). Without one there: that of a turret whose antennas and hatches
/// are left out, which a box cannot tell from it, a fifth of its length above its floor.
float roof_or_usual(const TurretRoof& roof, const Box& turret, float x, float z);

} // namespace tank
