#pragma once

#include "app/assets.h"

#include <string>

namespace platform {

/// Reads the tank's meshes and texture from a folder: the files that read_assets() asks for, there or in a
/// folder `tankobjs` in it, as the lab's archives have them. What a file is named decides; case does not.
/// Returns "" or what is wrong, with file and line where there is one; `assets` is untouched then.
std::string read_asset_folder(const std::string& folder, app::Assets& assets);

/// Does the same with the files that come with the program when `folder` is "": those of a folder `assets`
/// beside the executable or in one of the folders above it.
std::string read_asset_folder_or_own(const std::string& folder, app::Assets& assets);

} // namespace platform
