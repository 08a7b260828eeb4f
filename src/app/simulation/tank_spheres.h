#pragma once

#include "app/state/state.h"
#include "assets/assets.h"
#include "collision/sphere_hierarchy.h"
#include "tank/part_matrices.h"

#include <array>

namespace app {

/// Holds the bounding spheres of the tank: one around the whole, one for each of its 18 parts, by index of
/// the part. They are those of the high model whatever is drawn, and follow every pose.
class TankSpheres
{
public:
    /// Computes the spheres of the meshes. `assets` must outlive this.
    explicit TankSpheres(const assets::Assets& assets);

    /// Moves the spheres to where the state has the parts. Nothing is computed when nothing has moved, and
    /// nothing allocated unless the state asks for spheres fitted in another way than last time.
    /// Returns whether any sphere is another one now.
    bool refit(const State& state);

    const collision::SphereHierarchy& hierarchy() const { return hierarchy_; }

    /// Returns where the meshes are.
    const tank::PartMatrices& matrices() const { return matrices_; }

    /// Returns the sphere of a mesh of the high model, in its own coordinates.
    const collision::BoundingSphere& of_mesh(tank::MeshKind mesh, SphereFit fit) const;

private:
    void rebuild(SphereFit fit);

    const assets::Assets* assets_;
    std::array<collision::BoundingSphere, tank::MESH_KIND_COUNT> average_;
    std::array<collision::BoundingSphere, tank::MESH_KIND_COUNT> smallest_;
    collision::BoundingSphere whole_at_rest_;
    collision::SphereHierarchy hierarchy_;
    tank::PartMatrices matrices_;
    SphereFit fit_ = SphereFit::average;
    tank::JointAngles joints_;
    double x_ = 0.0;
    double z_ = 0.0;
};

} // namespace app
