#include "app/assets.h"

#include "app/asset_sources.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

namespace app {

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

void measure(Assets& assets)
{
    assets.wheel_radius = wheel_radius(assets);
    assets.track_links =
        find_track_links(assets.high[tank::index_of(tank::MeshKind::body)], assets.wheel_radius);
}

mesh::Result<Assets> read_assets(std::span<const AssetFile> files)
{
    // All names first: a missing file is said before time goes into reading the others.
    const mesh::Result<AssetSources> found = find_asset_sources(files);
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
    mesh::ReadError error;
    if (!read_meshes(sources, Level::high, assets, error) ||
        !read_meshes(sources, Level::low, assets, error)) {
        return error;
    }
    mesh::Result<mesh::Image> texture = mesh::read_image(sources.texture_name, sources.texture);
    if (!texture) {
        return texture.error();
    }
    assets.texture = std::move(texture.value());
    measure(assets);
    return assets;
}

} // namespace app
