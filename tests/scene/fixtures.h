#pragma once

#include "app/view/frame.h"
#include "assets/assets.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

/// Returns such a set whose body has a chain of three links on each side, a face each, and a fourth face that
/// rests.
inline assets::Assets assets_with_links()
{
    assets::Assets all{.layout = tank::default_layout(), .high = {}, .low = {}, .texture = {}};
    for (std::size_t i = 0; i < tank::MESH_KIND_COUNT; ++i) {
        all.high[i] = mesh_of(1);
        all.low[i] = mesh_of(1, false);
    }
    mesh::ObjMesh& body = all.high[tank::index_of(tank::MeshKind::body)];
    body = mesh_of(7);
    for (int link = 0; link < 6; ++link) {
        const char* const name = link < 3 ? "left_track_" : "right_track_";
        body.groups.push_back({name + std::to_string(link % 3), 1 + link, 1});
    }
    all.texture = {.width = 1, .height = 1, .channels = 3, .pixels = {1, 2, 3}};
    assets::measure(all);
    return all;
}

/// Returns a whole set of tiny meshes, each of another size, and a texture of 3 x 2 pixels.
inline assets::Assets assets()
{
    assets::Assets all{.layout = tank::default_layout(), .high = {}, .low = {}, .texture = {}};
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

/// Holds particles to be seen by views.
struct Particles
{
    explicit Particles(std::size_t count) : one(count, 1.0f), age(count, 0.25f), ramp(256)
    {
        for (std::size_t i = 0; i < count; ++i) {
            x.push_back(0.1f * static_cast<float>(i));
        }
        for (std::size_t i = 0; i < ramp.size(); ++i) {
            ramp[i] = {static_cast<std::uint8_t>(i), 20, 30, 200};
        }
    }

    /// Returns a view: velocity (1, 1, 1), a quarter of a life of 1 s is over.
    particles::ParticleView view() const
    {
        particles::ParticleView view{x, one, one, one, one, one, age, one, ramp, {0.1f, 0.3f}};
        view.streak_time = 0.1f;
        return view;
    }

    std::vector<float> x, one, age;
    std::vector<particles::Rgba> ramp;
};

/// Returns a frame in which there is one of everything that can be drawn: two tanks, spheres of both levels,
/// penetrated and not, a line with closest points, triangles, a shot, an axis, and particles of both kinds,
/// which `of` holds.
inline app::Frame full_frame(const assets::Assets& all, const Particles& of)
{
    app::State state;
    state.show.detail = app::Detail::both;
    state.show.wireframe = true;
    state.projectile.probe = app::Probe::line;
    state.projectile.handle = app::Handle::line_a;
    state.show.axis = app::AxisShown::turret;
    app::Frame frame = app::make_frame(state, all);
    const auto sphere = [&](double x, double radius, bool is_root, bool is_penetrated) {
        frame.spheres.push_back({.centre = {x, 1.0, 0.5},
                                 .radius = radius,
                                 .is_root = is_root,
                                 .part = tank::Part::body,
                                 .is_penetrated = is_penetrated});
    };
    sphere(0.25, 1.5, false, true);
    sphere(0.5, 4.0, true, true);
    sphere(0.75, 1.25, false, false);
    sphere(1.0, 1.0, false, true);
    frame.closest_points.push_back({{1, 2, 3}, {0, 1, 0}, true});
    frame.closest_points.push_back({{1, 2, 2}, {0, 1, 1}, false});
    frame.triangles.push_back({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0.1, 0.1, 0}, true});
    frame.shot = {.flies = true, .position = {2, 2, 2}, .velocity = {-10, 0, 0}, .radius = 0.1};
    for (particles::TextureKind texture :
         {particles::TextureKind::soft_dot, particles::TextureKind::streak}) {
        particles::ParticleView& view = frame.particles.push_back(of.view());
        view.texture = texture;
    }
    frame.particles[1].blending = particles::Blending::over;
    return frame;
}

} // namespace scene_test
