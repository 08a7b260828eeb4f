#include "tank/part_matrices.h"

#include "tank/rotation.h"

namespace tank {

namespace {

glm::dmat4 translation(const glm::dvec3& offset)
{
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(offset, 1.0);
    return matrix;
}

} // namespace

PartMatrices part_matrices(const Layout& layout, const RootPose& root, const JointAngles& angles)
{
    std::array<glm::dmat4, PART_COUNT> joints;
    PartMatrices matrices;
    for (Part part : ALL_PARTS) {
        const PartPlacement& placement = layout[part];
        const bool is_root = placement.parent == part;
        const glm::dmat4 parent = is_root ? translation(root.position) : joints[index_of(placement.parent)];
        glm::dmat4& joint = joints[index_of(part)];
        joint = parent * translation(placement.pivot) * rotation(placement.axis, angles[placement.joint]);
        if (const std::optional<Turn>& second = placement.second) {
            joint = joint * translation(second->pivot) * rotation(second->axis, angles[second->joint]);
        }
        matrices.joints[index_of(part)] = glm::mat4(joint);

        const glm::dmat4 mesh =
            rotation({0.0, 1.0, 0.0}, placement.mesh_yaw) * translation(placement.mesh_offset);
        matrices.meshes[index_of(part)] = glm::mat4(joint * mesh);
    }
    return matrices;
}

} // namespace tank
