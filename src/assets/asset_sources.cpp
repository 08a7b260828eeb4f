#include "assets/asset_sources.h"

#include "base/text.h"
#include "mesh/obj_reader.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace assets {

namespace {

using tank::MeshKind;

constexpr std::array<MeshFile, MESH_FILE_COUNT> MESH_FILES = {{
    {MeshKind::body, lod::Level::high, "tankbody.obj"},
    {MeshKind::turret, lod::Level::high, "tankturret.obj"},
    {MeshKind::main_gun, lod::Level::high, "tankmaingun.obj"},
    {MeshKind::secondary_gun, lod::Level::high, "tanksecondarygun.obj"},
    {MeshKind::wheel, lod::Level::high, "tankwheel.obj"},
    {MeshKind::body, lod::Level::low, "tankbodyLow.obj"},
    {MeshKind::turret, lod::Level::low, "tankturretLow.obj"},
    {MeshKind::main_gun, lod::Level::low, "tankmaingunLow.obj"},
    {MeshKind::secondary_gun, lod::Level::low, "tanksecondarygunLow.obj"},
    {MeshKind::wheel, lod::Level::low, "tankwheelLow.obj"},
}};

constexpr std::string_view TEXTURE_FILE_NAMES[] = {"texture.png", "texture.jpg", "texture.tga"};

/// Returns the files whose base name is `name`, upper or lower case.
std::vector<const AssetFile*> files_named(std::span<const AssetFile> files, std::string_view name)
{
    const std::string wanted = base::lower_case(name);
    std::vector<const AssetFile*> found;
    for (const AssetFile& file : files) {
        if (base::lower_case(base_name(file.name)) == wanted) {
            found.push_back(&file);
        }
    }
    return found;
}

base::ReadError given_twice(std::string_view name, std::span<const AssetFile* const> files)
{
    return {.file = std::string(name),
            .line = 0,
            .cause = "is there more than once, as " + base::in_quotes(files[0]->name) + " and as " +
                     base::in_quotes(files[1]->name)};
}

std::string_view as_text(std::span<const std::uint8_t> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns the file's bytes so that an empty file differs from none.
std::span<const std::uint8_t> present(std::span<const std::uint8_t> bytes)
{
    static constexpr std::uint8_t NOTHING = 0;
    return bytes.data() == nullptr ? std::span<const std::uint8_t>(&NOTHING, std::size_t{0}) : bytes;
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

std::string_view base_name(std::string_view path)
{
    const std::size_t slash = path.find_last_of("/\\");
    return slash == path.npos ? path : path.substr(slash + 1);
}

bool is_asset_name(std::string_view name)
{
    const std::string lower = base::lower_case(name);
    return std::any_of(MESH_FILES.begin(), MESH_FILES.end(),
                       [&](const MeshFile& file) { return base::lower_case(file.name) == lower; }) ||
           std::find(std::begin(TEXTURE_FILE_NAMES), std::end(TEXTURE_FILE_NAMES), lower) !=
               std::end(TEXTURE_FILE_NAMES);
}

base::Result<AssetSources> find_asset_sources(std::span<const AssetFile> files)
{
    AssetSources sources;
    for (std::size_t i = 0; i < MESH_FILES.size(); ++i) {
        const std::vector<const AssetFile*> found = files_named(files, MESH_FILES[i].name);
        if (found.size() > 1) {
            return given_twice(MESH_FILES[i].name, found);
        }
        if (!found.empty()) {
            sources.meshes[i] = present(found[0]->bytes);
        }
    }
    for (std::string_view name : TEXTURE_FILE_NAMES) {
        const std::vector<const AssetFile*> found = files_named(files, name);
        if (found.size() > 1) {
            return given_twice(name, found);
        }
        if (!found.empty() && sources.texture_name.empty()) {
            sources.texture = found[0]->bytes;
            sources.texture_name = name;
        }
    }
    return sources;
}

base::ReadError all_missing(std::span<const std::string> names)
{
    const std::vector<std::string_view> views(names.begin(), names.end());
    return {.file = "assets",
            .line = 0,
            .cause = base::listed(views) + (views.size() == 1 ? " is missing" : " are missing")};
}

bool read_meshes(const AssetSources& sources, lod::Level level, Assets& assets, base::ReadError& error)
{
    auto& meshes = level == lod::Level::high ? assets.high : assets.low;
    for (std::size_t i = 0; i < MESH_FILES.size(); ++i) {
        const MeshFile& file = MESH_FILES[i];
        if (file.level != level) {
            continue;
        }
        base::Result<mesh::ObjMesh> mesh = mesh::read_obj(file.name, as_text(sources.meshes[i]));
        if (!mesh) {
            error = mesh.error();
            return false;
        }
        meshes[tank::index_of(file.mesh)] = std::move(mesh.value());
    }
    return true;
}

} // namespace assets
