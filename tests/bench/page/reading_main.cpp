// Reads the tank's OBJ files into display lists in a page, as the program does at its start: what reading.js
// measures beside another reader. The files' bytes come from the page.

#include "assets/assets.h"
#include "assets/track_links.h"
#include "mesh/obj_reader.h"
#include "scene/tank/tank_lists.h"
#include "tank/part.h"

#include <legacygl/legacygl.h>

#include <emscripten.h>
#include <emscripten/html5.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace {

constexpr double WHEEL_RADIUS = 0.36; // metres: near enough to find the links by

std::array<std::string, assets::MESH_FILE_COUNT> texts; // by app::mesh_files()
scene::TankLists lists;

/// Reads a level's five files. Returns their triangles, 0 when one is not read.
std::size_t read(lod::Level level, scene::TankLists::Meshes& meshes)
{
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const assets::MeshFile& file = assets::mesh_files()[i];
        if (file.level != level) {
            continue;
        }
        const base::Result<mesh::ObjMesh> read = mesh::read_obj(file.name, texts[i]);
        if (!read) {
            return 0;
        }
        mesh::ObjMesh& mesh = meshes[tank::index_of(file.mesh)];
        mesh = read.value();
        triangles += mesh.faces.size();
    }
    return triangles;
}

} // namespace

extern "C" {

/// Makes a context for the canvas (a selector). Returns whether it can.
EMSCRIPTEN_KEEPALIVE int reading_open(const char* canvas)
{
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE webgl = emscripten_webgl_create_context(canvas, &attributes);
    return webgl > 0 && emscripten_webgl_make_context_current(webgl) == EMSCRIPTEN_RESULT_SUCCESS &&
           legacygl_create(nullptr, 16, 16, LEGACYGL_TARGET_WINDOW) != nullptr;
}

/// Returns where the bytes of a file are to be put; null when the tank has no file of that name.
EMSCRIPTEN_KEEPALIVE char* reading_file(const char* name, int size)
{
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (assets::mesh_files()[i].name == name) {
            texts[i].resize(size);
            return texts[i].data();
        }
    }
    return nullptr;
}

/// Reads all files into display lists. with_links: also those of the links' steps, which move.
/// Returns how many triangles there are, 0 when it fails.
EMSCRIPTEN_KEEPALIVE int reading_run(int with_links)
{
    scene::TankLists::Meshes high, low;
    const std::size_t triangles = read(lod::Level::high, high), low_triangles = read(lod::Level::low, low);
    assets::TrackLinks links;
    if (with_links) {
        links = assets::find_track_links(high[tank::index_of(tank::MeshKind::body)], WHEEL_RADIUS);
    }
    if (!lists.load_tank_objs(high, links) || !lists.load_low_detail_tank_objs(low)) {
        return 0;
    }
    return triangles * low_triangles == 0 ? 0 : static_cast<int>(triangles + low_triangles);
}

} // extern "C"
