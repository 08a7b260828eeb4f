#include "assets/assets.h"

#include "assets/asset_sources.h"
#include "assets/roof.h"
#include "tank/mesh_box.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace assets {

namespace {

/// Returns how far the wheel's mesh reaches from its axle.
double wheel_radius(const Assets& assets)
{
    const tank::PartPlacement& wheel = assets.layout[tank::Part::wheel_left_1];
    double radius = 0.0;
    for (const glm::vec3& position : assets.high[tank::index_of(wheel.mesh)].positions) {
        const glm::dvec3 from_axle(position + wheel.mesh_offset);
        radius = std::max(radius, std::sqrt(from_axle.y * from_axle.y + from_axle.z * from_axle.z));
    }
    return radius;
}

/// Returns the box of a part's mesh in the part's joint frame.
tank::Box box_in_joint(const Assets& assets, tank::Part part)
{
    const tank::PartPlacement& placement = assets.layout[part];
    tank::Box box{glm::vec3(std::numeric_limits<float>::max()),
                  glm::vec3(std::numeric_limits<float>::lowest())};
    for (const glm::vec3& position : assets.high[tank::index_of(placement.mesh)].positions) {
        box.minimum = glm::min(box.minimum, position + placement.mesh_offset);
        box.maximum = glm::max(box.maximum, position + placement.mesh_offset);
    }
    return box;
}

/// Returns where the gunner looks out: a little above the turret's roof, a quarter of its width to the right
/// of the gun and half way from the turret's axis to the trunnion. There tanks have their sight.
glm::vec3 sight_of(const Assets& assets)
{
    constexpr float ABOVE_ROOF = 0.06f;
    const tank::PartPlacement& turret = assets.layout[tank::Part::turret];
    const tank::Box box = box_in_joint(assets, tank::Part::turret);
    const glm::vec3& trunnion = assets.layout[tank::Part::main_gun].pivot;
    const float width = box.maximum.x - box.minimum.x;
    const float x = trunnion.x - 0.25f * width;
    const float z = 0.5f * trunnion.z;
    const tank::TurretRoof roof = roof_of(assets.high[tank::index_of(turret.mesh)]);
    const std::optional<float> height = roof(x - turret.mesh_offset.x, z - turret.mesh_offset.z);
    const float roof_y = height ? *height + turret.mesh_offset.y : trunnion.y + 0.15f * width;
    return {x, roof_y + ABOVE_ROOF, z};
}

/// Returns the middle of the barrel's end: of the last hundredth of the gun's length.
glm::vec3 muzzle_of(const Assets& assets)
{
    const tank::PartPlacement& gun = assets.layout[tank::Part::main_gun];
    const tank::Box box = box_in_joint(assets, tank::Part::main_gun);
    const float last = box.maximum.z - 0.01f * (box.maximum.z - box.minimum.z);
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& position : assets.high[tank::index_of(gun.mesh)].positions) {
        if (const glm::vec3 place = position + gun.mesh_offset; place.z >= last) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    }
    return {0.5f * (low.x + high.x), 0.5f * (low.y + high.y), box.maximum.z};
}

} // namespace

void measure(Assets& assets)
{
    assets.wheel_radius = wheel_radius(assets);
    assets.track_links =
        find_track_links(assets.high[tank::index_of(tank::MeshKind::body)], assets.wheel_radius);
    assets.sight = sight_of(assets);
    assets.muzzle = muzzle_of(assets);
}

void paint_low_model(Assets& assets, const PaintView& view)
{
    for (std::size_t mesh = 0; assets.has_low_model && mesh < tank::MESH_KIND_COUNT; ++mesh) {
        assets.low_paint[mesh] = paint_of(assets.low[mesh], assets.high[mesh], assets.texture, view);
    }
}

base::Result<Assets> read_assets(std::span<const AssetFile> files, const PaintView& view)
{
    // All names first: a missing file is said before time goes into reading the others.
    const base::Result<AssetSources> found = find_asset_sources(files);
    if (!found) {
        return found.error();
    }
    const AssetSources& sources = found.value();
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < MESH_FILE_COUNT; ++i) {
        if (!sources.has(i)) {
            missing.emplace_back(mesh_files()[i].name);
        }
    }
    if (sources.texture_name.empty()) {
        missing.push_back(std::string(texture_file_names()[0]) + " (or .jpg, .tga)");
    }
    if (!missing.empty()) {
        return all_missing(missing);
    }

    Assets assets;
    base::ReadError error;
    if (!read_meshes(sources, lod::Level::high, assets, error) ||
        !read_meshes(sources, lod::Level::low, assets, error)) {
        return error;
    }
    base::Result<image::Image> texture = image::read_image(sources.texture_name, sources.texture);
    if (!texture) {
        return texture.error();
    }
    assets.texture = std::move(texture.value());
    measure(assets);
    paint_low_model(assets, view);
    return assets;
}

} // namespace assets
