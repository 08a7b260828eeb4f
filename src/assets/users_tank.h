#pragma once

#include "assets/assets.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace assets {

/// Says whose meshes a set of files holds, told by their bounding boxes, in any unit.
enum class TankData : std::uint8_t
{
    ours,     ///< the program's own
    original, ///< the lab's: tankLab.zip and tankLOD.zip
    other,
};

/// Holds a tank that a user brought.
struct UsersTank
{
    Assets assets;
    TankData data;
    std::vector<std::string> notes; ///< what people should know of it, a sentence each
};

/// Reads a tank from a user's files, found by their base names; other files are ignored, and a file that is
/// there twice with the same content counts once. It is laid out by tank::default_layout(),
/// tank::original_layout() or, if it is neither's, tank::bounding_box_layout(), and scaled so that its hull
/// is as long as ours. Without low meshes the high ones take their place, without a texture a plain colour.
/// Errors: high meshes that are missing, or low ones while others are there, all named in one; a name given
/// twice; whatever is wrong inside a file, with its line; meshes that no scale makes a tank. Either
/// everything is read or nothing.
base::Result<UsersTank> read_users_tank(std::span<const AssetFile> files, const PaintView& view);

} // namespace assets
