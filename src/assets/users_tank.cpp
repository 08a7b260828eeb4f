#include "assets/users_tank.h"

#include "assets/asset_sources.h"
#include "assets/original_texture.h"
#include "assets/roof.h"
#include "assets/winding.h"
#include "base/measures.h"
#include "base/text.h"
#include "tank/bounding_box_layout.h"
#include "tank/original_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace assets {

namespace {

using tank::MeshKind;
using Meshes = std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT>;

/// No part reaches further from its mesh's origin, in metres: a hundred hulls.
constexpr double MAX_CORNER_DISTANCE = 1000.0;

/// No hull is scaled by more than this, either way, and none by less than what files round to.
constexpr double MAX_SCALE = 1e6;
constexpr double ROUNDING = 1e-6;

/// What a tank without a texture is painted with.
constexpr std::uint8_t PLAIN_COLOUR[] = {116, 118, 88};

bool has_equal_content(const AssetFile& one, const AssetFile& other)
{
    return base::lower_case(base_name(one.name)) == base::lower_case(base_name(other.name)) &&
           std::equal(one.bytes.begin(), one.bytes.end(), other.bytes.begin(), other.bytes.end());
}

/// Returns the files of which a tank is made, each content once.
std::vector<AssetFile> without_copies(std::span<const AssetFile> files)
{
    std::vector<AssetFile> kept;
    for (const AssetFile& file : files) {
        if (is_asset_name(base_name(file.name)) &&
            std::none_of(kept.begin(), kept.end(),
                         [&](const AssetFile& other) { return has_equal_content(file, other); })) {
            kept.push_back(file);
        }
    }
    return kept;
}

/// Returns the names of a level's meshes that are not there.
std::vector<std::string> missing_meshes(const AssetSources& sources, lod::Level level)
{
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < MESH_FILE_COUNT; ++i) {
        if (mesh_files()[i].level == level && !sources.has(i)) {
            missing.emplace_back(mesh_files()[i].name);
        }
    }
    return missing;
}

tank::MeshBoxes boxes_of(const Meshes& meshes)
{
    tank::MeshBoxes boxes{};
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        boxes[i] = {meshes[i].positions[0], meshes[i].positions[0]};
        for (const glm::vec3& position : meshes[i].positions) {
            boxes[i] = {glm::min(boxes[i].minimum, position), glm::max(boxes[i].maximum, position)};
        }
    }
    return boxes;
}

TankData data_of(const tank::MeshBoxes& boxes)
{
    if (tank::resembles(boxes, tank::default_boxes())) {
        return TankData::ours;
    }
    return tank::resembles(boxes, tank::original_boxes()) ? TankData::original : TankData::other;
}

/// Scales meshes to metres. Returns the name of a mesh that reaches too far then, or "".
std::string_view scale_meshes(Meshes& meshes, lod::Level level, double scale)
{
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        for (glm::vec3& position : meshes[i].positions) {
            const glm::dvec3 metres = glm::dvec3(position) * scale;
            for (int axis = 0; axis < 3; ++axis) {
                if (!(std::abs(metres[axis]) <= MAX_CORNER_DISTANCE)) {
                    return mesh_files()[tank::MESH_KIND_COUNT * static_cast<std::size_t>(level) + i].name;
                }
            }
            position = glm::vec3(metres);
        }
    }
    return {};
}

/// Scales both models so that the hull is as long as ours. Returns "" or why they cannot be.
std::string scale_to_our_hull(Assets& assets, std::string& file)
{
    const double length = tank::length_of(tank::box_of(boxes_of(assets.high), MeshKind::body));
    const double ours = tank::length_of(tank::box_of(tank::default_boxes(), MeshKind::body));
    assets.scale = ours / length;
    if (!(assets.scale >= 1.0 / MAX_SCALE && assets.scale <= MAX_SCALE)) {
        file = mesh_files()[0].name;
        return "the body's length along Z, the direction of the gun, is " +
               std::string(length > 1.0 ? "far too large" : "nothing or next to it") +
               ", so it cannot be brought to a tank's size";
    }
    if (std::abs(assets.scale - 1.0) < ROUNDING) {
        assets.scale = 1.0;
    }
    for (lod::Level level : {lod::Level::high, lod::Level::low}) {
        Meshes& meshes = level == lod::Level::high ? assets.high : assets.low;
        if (const std::string_view name = scale_meshes(meshes, level, assets.scale); !name.empty()) {
            file = name;
            return "the part lies more than " + base::in_metres(MAX_CORNER_DISTANCE) +
                   " m from its origin once the body is as long as a tank's; model all parts in one unit";
        }
    }
    return "";
}

/// Assembles meshes that are in metres.
void lay_out(Assets& assets, TankData data)
{
    const tank::TurretRoof roof = roof_of(assets.high[tank::index_of(MeshKind::turret)]);
    const tank::MeshBoxes boxes = boxes_of(assets.high);
    switch (data) {
    case TankData::ours:
        break; // it is what Assets begin with
    case TankData::original: {
        // The layout is in the lab's units, the roof in metres.
        const double unit = tank::length_of(tank::box_of(boxes, MeshKind::body)) /
                            tank::length_of(tank::box_of(tank::original_boxes(), MeshKind::body));
        const tank::TurretRoof roof_in_units = [&](float x, float z) -> std::optional<float> {
            const auto metres = static_cast<float>(unit);
            const std::optional<float> height = roof(x * metres, z * metres);
            return height ? std::optional(*height / metres) : std::nullopt;
        };
        assets.layout = tank::scaled(tank::original_layout(roof_in_units), unit);
        assets.low_layout = tank::scaled(tank::original_low_layout(roof_in_units), unit);
        break;
    }
    case TankData::other:
        assets.layout = tank::bounding_box_layout(boxes, roof);
        break;
    }
}

/// Returns the texture of the files, the right way up, or a plain colour.
base::Result<image::Image> read_texture(const AssetSources& sources, TankData data)
{
    if (sources.texture_name.empty()) {
        return image::Image{.width = 1,
                            .height = 1,
                            .channels = 3,
                            .pixels = {std::begin(PLAIN_COLOUR), std::end(PLAIN_COLOUR)}};
    }
    base::Result<image::Image> texture = image::read_image(sources.texture_name, sources.texture);
    if (texture && data == TankData::original && has_form_of_original_texture(sources.texture)) {
        turn_upside_down(texture.value());
    }
    return texture;
}

std::vector<std::string> notes_on(const UsersTank& tank, bool has_texture)
{
    std::vector<std::string> notes;
    const double hull = tank::length_of(tank::box_of(tank::default_boxes(), MeshKind::body));
    if (tank.data == TankData::original) {
        notes.emplace_back("This is the lab's own tank, assembled by its pivots.");
    } else if (tank.data == TankData::other) {
        notes.emplace_back("These meshes are not the lab's, so they are laid out by their bounding boxes.");
    }
    if (tank.data != TankData::ours) {
        notes.push_back("It is scaled by " + base::factor_text(tank.assets.scale) + ", so that its hull is " +
                        base::in_metres(hull) + " m long.");
    }
    if (!tank.assets.has_low_model) {
        notes.emplace_back("There is no low model among the files; the high one is shown in its place.");
    }
    if (!has_texture) {
        notes.emplace_back("There is no texture among the files; the tank is painted in one colour.");
    }
    return notes;
}

} // namespace

base::Result<UsersTank> read_users_tank(std::span<const AssetFile> files, const PaintView& view)
{
    const base::Result<AssetSources> found = find_asset_sources(without_copies(files));
    if (!found) {
        return found.error();
    }
    const AssetSources& sources = found.value();
    std::vector<std::string> missing = missing_meshes(sources, lod::Level::high);
    const std::vector<std::string> missing_low = missing_meshes(sources, lod::Level::low);
    UsersTank tank{.assets = {}, .data = TankData::other, .notes = {}};
    Assets& assets = tank.assets;
    assets.has_low_model = missing_low.size() < tank::MESH_KIND_COUNT;
    if (assets.has_low_model) {
        missing.insert(missing.end(), missing_low.begin(), missing_low.end());
    }
    if (!missing.empty()) {
        return all_missing(missing);
    }

    base::ReadError error;
    if (!read_meshes(sources, lod::Level::high, assets, error) ||
        (assets.has_low_model && !read_meshes(sources, lod::Level::low, assets, error))) {
        return error;
    }
    tank.data = data_of(boxes_of(assets.high));
    if (error.cause = scale_to_our_hull(assets, error.file); !error.cause.empty()) {
        return error;
    }
    lay_out(assets, tank.data);
    measure(assets);
    if (tank.data != TankData::ours) {
        assets.is_one_sided = false; // nobody knows whether their surfaces are closed
        wind_by_normals(assets.high);
        wind_by_normals(assets.low);
    }
    base::Result<image::Image> texture = read_texture(sources, tank.data);
    if (!texture) {
        return texture.error();
    }
    assets.texture = std::move(texture.value());
    paint_low_model(assets, view);
    tank.notes = notes_on(tank, !sources.texture_name.empty());
    return tank;
}

} // namespace assets
