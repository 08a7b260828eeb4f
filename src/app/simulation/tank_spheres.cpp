#include "app/simulation/tank_spheres.h"

#include "collision/bounding_sphere.h"
#include "collision/smallest_sphere.h"

namespace app {

TankSpheres::TankSpheres(const assets::Assets& assets)
    : assets_(&assets), matrices_(tank::part_matrices(assets.layout, {}, {}))
{
    for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
        average_[mesh] = collision::average_sphere(assets.high[mesh].positions);
        smallest_[mesh] = collision::smallest_sphere(assets.high[mesh].positions);
    }
    std::array<collision::PlacedPoints, tank::PART_COUNT> placed{};
    for (tank::Part part : tank::ALL_PARTS) {
        const std::size_t mesh = tank::index_of(assets.layout[part].mesh);
        placed[tank::index_of(part)] = {assets.high[mesh].positions, matrices_.mesh(part)};
    }
    whole_at_rest_ = collision::average_sphere(placed);
    rebuild(SphereFit::average);
}

const collision::BoundingSphere& TankSpheres::of_mesh(tank::MeshKind mesh, SphereFit fit) const
{
    return (fit == SphereFit::average ? average_ : smallest_)[tank::index_of(mesh)];
}

void TankSpheres::rebuild(SphereFit fit)
{
    std::array<collision::BoundingSphere, tank::PART_COUNT> spheres;
    for (tank::Part part : tank::ALL_PARTS) {
        spheres[tank::index_of(part)] = of_mesh(assets_->layout[part].mesh, fit);
    }
    hierarchy_ = collision::SphereHierarchy(spheres);
    hierarchy_.carry_whole(whole_at_rest_, tank::index_of(tank::Part::body));
    hierarchy_.refit(matrices_.meshes);
    fit_ = fit;
}

bool TankSpheres::refit(const State& state)
{
    const bool is_refitted = state.show.fit != fit_;
    if (is_refitted) {
        rebuild(state.show.fit);
    }
    if (state.joints == joints_ && state.x == x_ && state.z == z_) {
        return is_refitted;
    }
    joints_ = state.joints;
    x_ = state.x;
    z_ = state.z;
    matrices_ = tank::part_matrices(assets_->layout, {{x_, 0.0, z_}}, joints_);
    hierarchy_.refit(matrices_.meshes);
    return true;
}

} // namespace app
