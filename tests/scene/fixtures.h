#pragma once

#include "app/assets.h"

namespace scene_test {

/// Returns a mesh of `faces` triangles whose numbers all differ, and whose corners index each array
/// otherwise. textured: else no corner has a texture coordinate.
inline mesh::ObjMesh mesh_of(int faces, bool textured = true)
{
    mesh::ObjMesh obj;
    for (int i = 0; i < 3 * faces; ++i) {
        const auto n = static_cast<float>(i);
        obj.positions.push_back({n, n + 0.25f, n + 0.5f});
        obj.normals.push_back({0.0f, 1.0f, n});
        obj.texture_coordinates.push_back({n / 8.0f, -n});
    }
    const int last = 3 * faces - 1;
    for (int face = 0; face < faces; ++face) {
        mesh::Face corners{};
        for (int corner = 0; corner < 3; ++corner) {
            const int i = 3 * face + corner;
            corners.vertices[static_cast<std::size_t>(corner)] = {.position = i,
                                                                  .normal = last - i,
                                                                  .texture_coordinate =
                                                                      textured ? (i + 1) % (last + 1) : -1};
        }
        obj.faces.push_back(corners);
    }
    return obj;
}

/// Returns a whole set of tiny meshes, each of another size, and a texture of 3 x 2 pixels.
inline app::Assets assets()
{
    app::Assets all{.layout = tank::default_layout(), .high = {}, .low = {}, .texture = {}};
    for (int i = 0; i < static_cast<int>(tank::MESH_KIND_COUNT); ++i) {
        all.high[static_cast<std::size_t>(i)] = mesh_of(i + 1);
        all.low[static_cast<std::size_t>(i)] = mesh_of(1, false);
    }
    all.texture = {.width = 3, .height = 2, .channels = 3, .pixels = {}};
    for (int i = 0; i < 3 * 2 * 3; ++i) {
        all.texture.pixels.push_back(static_cast<std::uint8_t>(10 * i));
    }
    return all;
}

} // namespace scene_test
