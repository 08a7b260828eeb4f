#include "app/assets.h"

#include "app/text.h"
#include "mesh/obj_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

namespace app {

namespace {

using tank::MeshKind;

constexpr MeshFile MESH_FILES[] = {
    {MeshKind::body, Level::high, "tankbody.obj"},
    {MeshKind::turret, Level::high, "tankturret.obj"},
    {MeshKind::main_gun, Level::high, "tankmaingun.obj"},
    {MeshKind::secondary_gun, Level::high, "tanksecondarygun.obj"},
    {MeshKind::wheel, Level::high, "tankwheel.obj"},
    {MeshKind::body, Level::low, "tankbodyLow.obj"},
    {MeshKind::turret, Level::low, "tankturretLow.obj"},
    {MeshKind::main_gun, Level::low, "tankmaingunLow.obj"},
    {MeshKind::secondary_gun, Level::low, "tanksecondarygunLow.obj"},
    {MeshKind::wheel, Level::low, "tankwheelLow.obj"},
};

constexpr std::string_view TEXTURE_FILE_NAMES[] = {"texture.png", "texture.jpg", "texture.tga"};

std::string_view base_name(std::string_view path)
{
    const std::size_t slash = path.find_last_of("/\\");
    return slash == path.npos ? path : path.substr(slash + 1);
}

/// Returns the files whose base name is `name`, upper or lower case.
std::vector<const AssetFile*> files_named(std::span<const AssetFile> files, std::string_view name)
{
    const std::string wanted = lower_case(name);
    std::vector<const AssetFile*> found;
    for (const AssetFile& file : files) {
        if (lower_case(base_name(file.name)) == wanted) {
            found.push_back(&file);
        }
    }
    return found;
}

mesh::ReadError given_twice(std::string_view name, std::span<const AssetFile* const> files)
{
    return {.file = std::string(name),
            .line = 0,
            .cause = "is there more than once, as " + in_quotes(files[0]->name) + " and as " +
                     in_quotes(files[1]->name)};
}

mesh::ReadError all_missing(std::span<const std::string> missing)
{
    std::vector<std::string_view> names(missing.begin(), missing.end());
    return {.file = "assets",
            .line = 0,
            .cause = listed(names) + (names.size() == 1 ? " is missing" : " are missing")};
}

std::string_view as_text(std::span<const std::uint8_t> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

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

} // namespace

std::span<const MeshFile> mesh_files()
{
    return MESH_FILES;
}

std::span<const std::string_view> texture_file_names()
{
    return TEXTURE_FILE_NAMES;
}

mesh::Result<Assets> read_assets(std::span<const AssetFile> files)
{
    // All names first: a missing file is said before time goes into reading the others.
    std::array<std::span<const std::uint8_t>, std::size(MESH_FILES)> sources;
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::vector<const AssetFile*> found = files_named(files, MESH_FILES[i].name);
        if (found.size() > 1) {
            return given_twice(MESH_FILES[i].name, found);
        }
        if (found.empty()) {
            missing.emplace_back(MESH_FILES[i].name);
        } else {
            sources[i] = found[0]->bytes;
        }
    }
    std::string_view texture_name; // of the first one that is there
    std::span<const std::uint8_t> texture_source;
    for (std::string_view name : TEXTURE_FILE_NAMES) {
        const std::vector<const AssetFile*> found = files_named(files, name);
        if (found.size() > 1) {
            return given_twice(name, found);
        }
        if (!found.empty() && texture_name.empty()) {
            texture_source = found[0]->bytes;
            texture_name = name;
        }
    }
    if (texture_name.empty()) {
        missing.push_back(std::string(TEXTURE_FILE_NAMES[0]) + " (or .jpg, .tga)");
    }
    if (!missing.empty()) {
        return all_missing(missing);
    }

    Assets assets{};
    assets.layout = tank::default_layout();
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const MeshFile& file = MESH_FILES[i];
        mesh::Result<mesh::ObjMesh> mesh = mesh::read_obj(file.name, as_text(sources[i]));
        if (!mesh) {
            return mesh.error();
        }
        auto& meshes = file.level == Level::high ? assets.high : assets.low;
        meshes[tank::index_of(file.mesh)] = std::move(mesh.value());
    }
    mesh::Result<mesh::Image> texture = mesh::read_image(texture_name, texture_source);
    if (!texture) {
        return texture.error();
    }
    assets.texture = std::move(texture.value());
    assets.wheel_radius = wheel_radius(assets);
    return assets;
}

} // namespace app
