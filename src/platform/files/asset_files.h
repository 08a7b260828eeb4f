#pragma once

#include "assets/assets.h"
#include "assets/users_tank.h"

#include <string>

namespace platform {

/// Reads the program's own tank from a folder: the files that read_assets() asks for, there or in a folder in
/// it, such as `tankobjs`. What a file is named decides; case does not.
/// Returns "" or what is wrong, with file and line where there is one; `assets` is untouched then.
std::string read_asset_folder(const std::string& folder, assets::Assets& assets);

/// Reads the tank of a folder that the user names, in whatever folders below it the files lie: see
/// read_users_tank(). With `folder` "" it is the program's own, from a folder `assets` beside the executable
/// or in one of the folders above it. Returns "" or what is wrong, with file and line where there is one;
/// `tank` is untouched then.
std::string read_tank(const std::string& folder, assets::UsersTank& tank);

} // namespace platform
