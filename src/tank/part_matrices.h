#pragma once

#include "tank/layout.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace tank {

/// Says where the tank stands, in metres; its heading is the joint `heading`.
struct RootPose
{
    glm::dvec3 position{0.0};
};

/// Holds two world matrices for every part, in column-major order as GL has it.
struct PartMatrices
{
    std::array<glm::mat4, PART_COUNT> joints; ///< the frame that the part's children hang in
    std::array<glm::mat4, PART_COUNT> meshes; ///< takes the part's mesh to the world

    const glm::mat4& joint(Part part) const { return joints[index_of(part)]; }
    const glm::mat4& mesh(Part part) const { return meshes[index_of(part)]; }
};

/// Computes the world matrices of all parts, with the formula at PartPlacement, in double, rounded to float
/// once. Drawing never uses them: it nests the same placements on GL's matrix stack, and a test holds the two
/// together. Precondition: position and angles are finite. The angles are not clamped here.
PartMatrices part_matrices(const Layout& layout, const RootPose& root, const JointAngles& angles);

} // namespace tank
