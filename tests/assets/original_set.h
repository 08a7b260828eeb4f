#pragma once

#include "asset_fixtures.h"
#include "tank/mesh_box.h"

#include <string>

namespace assets {

/// What a set like the lab's can be made without, to see what each quirk of it does.
struct OriginalSetOptions
{
    double unit = 1.0;          ///< how long one of the lab's units is written
    bool varied_normals = true; ///< of lengths 0.2 to 3.8; else 1
    bool reversed_faces = true; ///< 1 triangle in 17 winds against its normals
    bool has_low_model = true;
    bool has_texture = true;
    float turret_stretch = 1.0f; ///< of the turret along Z: another one is another tank
};

/// The height of the made turret's roof, in its mesh: its antennas reach far higher.
constexpr float MADE_ROOF = 15.0f;

/// Makes files with the bounding boxes and the quirks of the lab's own data: `vt` of three numbers, normals
/// of any length, faces that wind against them, `v//vn` in the low files, `g` and `s` lines, no mtllib, and a
/// run-length encoded TGA whose header has its rows the wrong way round.
Files original_set(const OriginalSetOptions& options = {});

/// Returns the texture of the set: 1024 x 1024, red in the upper half of the picture, blue in the lower.
std::string original_tga();

} // namespace assets
