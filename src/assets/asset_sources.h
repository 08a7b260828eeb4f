#pragma once

#include "assets/assets.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace assets {

/// Says where the bytes of each file of a tank are, by the table of mesh_files(). A mesh that is not there
/// has no data; a texture that is not there no name.
struct AssetSources
{
    std::array<std::span<const std::uint8_t>, MESH_FILE_COUNT> meshes;
    std::string_view texture_name; ///< of the table, of the first one that is there
    std::span<const std::uint8_t> texture;

    bool has(std::size_t mesh_file) const { return meshes[mesh_file].data() != nullptr; }
};

/// Returns a path without its folders.
std::string_view base_name(std::string_view path);

/// Tells whether a file of this base name, upper or lower case, belongs to a tank.
bool is_asset_name(std::string_view name);

/// Finds the files of a tank by their base names, upper or lower case; other files are ignored.
/// Errors: a name given twice.
base::Result<AssetSources> find_asset_sources(std::span<const AssetFile> files);

/// Says that files are missing. Precondition: there is at least one name.
base::ReadError all_missing(std::span<const std::string> names);

/// Reads the meshes of a level into their places. Precondition: all of that level are there.
/// Returns whether it could; if not, why, in `error`.
bool read_meshes(const AssetSources& sources, lod::Level level, Assets& assets, base::ReadError& error);

} // namespace assets
