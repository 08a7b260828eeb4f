#pragma once

#include "assets/low_paint.h"
#include "assets/track_links.h"
#include "base/result.h"
#include "image/image.h"
#include "lod/level.h"
#include "mesh/obj_mesh.h"
#include "tank/layout.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace assets {

/// Holds all data that the program reads from files, and the layout that assembles it. Never changes after
/// reading.
struct Assets
{
    tank::Layout layout = tank::default_layout();
    std::optional<tank::Layout> low_layout = {}; ///< of the low meshes, where it is another one
    std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT> high = {}; ///< by tank::index_of(MeshKind)
    std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT> low = {};  ///< without faces when there is no low model
    image::Image texture = {};
    LowPaint low_paint = {};     ///< of the low meshes: what the texture shows on the high ones
    double wheel_radius = 0.0;   ///< metres: how far the wheel's mesh reaches from its axle
    TrackLinks track_links = {}; ///< of the high body's mesh
    glm::vec3 sight{0.0f};       ///< where the gunner looks out, in the turret's joint frame
    glm::vec3 muzzle{0.0f};      ///< where the barrel ends, in the main gun's joint frame
    bool has_low_model = true;   ///< else the high one is drawn in its place
    bool is_one_sided = true;    ///< no face is seen from behind; else its back is drawn, too
    double scale = 1.0;          ///< metres for a unit of the files; positions and layouts are in metres

    /// Returns the meshes that are drawn at a level, and how they are assembled.
    const std::array<mesh::ObjMesh, tank::MESH_KIND_COUNT>& meshes(lod::Level level) const
    {
        return level == lod::Level::high || !has_low_model ? high : low;
    }
    const tank::Layout& layout_of(lod::Level level) const
    {
        return level == lod::Level::low && low_layout ? *low_layout : layout;
    }
};

/// Says which mesh a file holds.
struct MeshFile
{
    tank::MeshKind mesh;
    lod::Level level;
    std::string_view name; ///< without a folder, such as "tankbodyLow.obj"
};

constexpr std::size_t MESH_FILE_COUNT = lod::LEVEL_COUNT * tank::MESH_KIND_COUNT;

/// Returns the one table of OBJ files that make a tank: ten, under the lab's names, the high ones first.
std::span<const MeshFile> mesh_files();

/// Returns the names that the texture may have; the first one that is there is used.
std::span<const std::string_view> texture_file_names();

/// Names a file's bytes; the view must outlive the reading only.
struct AssetFile
{
    std::string_view name; ///< folders before the last / or \ and upper or lower case make no difference
    std::span<const std::uint8_t> bytes;
};

/// Works out what follows from the high meshes and the layout: the wheel's radius, the track's links, the
/// gunner's sight and the muzzle. Precondition: no mesh but the wheels' is turned by its layout.
void measure(Assets& assets);

/// Paints the low meshes as the texture shows the high ones. Does nothing where there is no low model.
/// Precondition: meshes and texture are read, the meshes in metres.
void paint_low_model(Assets& assets, const PaintView& view);

/// Reads the ten meshes and the texture and lays them out by tank::default_layout(). Other files are ignored.
/// Errors: files that are missing, all named in one; a name given twice; whatever is wrong inside a file,
/// with its line. Either everything is read or nothing.
base::Result<Assets> read_assets(std::span<const AssetFile> files, const PaintView& view);

} // namespace assets
