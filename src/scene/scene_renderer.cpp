#include "scene/scene_renderer.h"

#include "scene/drawing/lights.h"
#include "scene/drawing/materials.h"
#include "scene/drawing/scoped_state.h"
#include "scene/drawing/texture.h"
#include "scene/markers/markers.h"
#include "scene/markers/reticle.h"
#include "scene/markers/spheres.h"
#include "scene/surroundings/shadow.h"
#include "scene/tank/draw_tank.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <GL/gl.h>
#include <GL/glu.h>

namespace scene {
namespace {

void set_camera(const app::CameraView& camera, int width, int height)
{
    const double aspect = static_cast<double>(width) / static_cast<double>(height);
    const double from_bottom_to_top =
        2.0 * std::atan(app::vertical_fov_scale(aspect) * std::tan(0.5 * camera.field_of_view));
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(from_bottom_to_top * 180.0 / std::numbers::pi, aspect, camera.near_plane,
                   camera.far_plane);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(camera.eye.x, camera.eye.y, camera.eye.z, camera.centre.x, camera.centre.y, camera.centre.z,
              camera.up.x, camera.up.y, camera.up.z);
}

/// Lets glClear fill with what is seen where neither sky nor ground is drawn.
void clear_to_haze()
{
    glClearColor(0.78f, 0.80f, 0.79f, 1.0f);
}

/// Clears the window to what is left between panes.
void clear_to_gaps()
{
    glClearColor(0.20f, 0.22f, 0.24f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    clear_to_haze();
}

/// Sets what no frame changes, and what each drawing finds: see scoped_state.h.
void set_up_state()
{
    glShadeModel(GL_SMOOTH);
    glEnable(GL_NORMALIZE); // the lab's own meshes have normals of any length, and scaled spheres
    glEnable(GL_DEPTH_TEST);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glDepthFunc(GL_LEQUAL);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    clear_to_haze();
    set_up_lights();
}

struct PanePixels
{
    int x, y, width, height;
};

/// Returns where a pane lies in the window: between panes, but not around them, a line of the clear colour.
PanePixels pixels_of(const app::PaneInFrame& pane, int width, int height)
{
    const auto first = [&](int size, int index) { return size * index / pane.parts + (index > 0 ? 1 : 0); };
    const auto last = [&](int size, int index) {
        return size * (index + 1) / pane.parts - (index + 1 < pane.parts ? 1 : 0);
    };
    const int x = first(width, pane.left);
    const int y = first(height, pane.bottom);
    return {x, y, std::max(1, last(width, pane.left) - x), std::max(1, last(height, pane.bottom) - y)};
}

/// Returns the name of an error, as the specification has it.
const char* error_name(GLenum error)
{
    switch (error) {
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE"; // an image larger than the system takes
    case GL_NO_ERROR:
        return "no names for display lists left";
    default:
        return "an unexpected error";
    }
}

std::string refusal(GLenum error)
{
    return std::string("OpenGL could not take the tank's meshes and texture: ") + error_name(error) + ".";
}

} // namespace

std::string SceneRenderer::load(const assets::Assets& assets)
{
    set_up_state();
    if (std::string fault = load_tank(assets); !fault.empty()) {
        return fault;
    }
    particle_drawing_.load();
    const bool loaded = surroundings_.load() && shapes_.load();
    const GLenum error = glGetError();
    return loaded && error == GL_NO_ERROR ? "" : refusal(error);
}

std::string SceneRenderer::load_tank(const assets::Assets& assets)
{
    assets_ = &assets;
    if (texture_ != 0) {
        glDeleteTextures(1, &texture_);
    }
    texture_ = upload_texture(assets.texture);
    const bool loaded = tank_lists_.load_tank_objs(assets.high, assets.track_links) &&
                        tank_lists_.load_low_detail_tank_objs(assets.low, assets.low_paint) &&
                        tank_lists_.load_shapes(assets.meshes(shadow_level(assets)));
    const GLenum error = glGetError();
    return loaded && error == GL_NO_ERROR ? "" : refusal(error);
}

void SceneRenderer::draw(const app::Frame& frame, int width, int height) const
{
    if (frame.panes.size() == 1) {
        glViewport(0, 0, width, height);
        draw_view(frame, width, height);
        return;
    }
    clear_to_gaps();
    // A viewport cuts off what is outside of it, but neither clearing nor the width of lines: those the
    // scissors cut.
    const Enabled scissors(GL_SCISSOR_TEST);
    app::Frame view = frame;
    for (const app::PaneInFrame& pane : frame.panes) {
        const PanePixels pixels = pixels_of(pane, width, height);
        glViewport(pixels.x, pixels.y, pixels.width, pixels.height);
        glScissor(pixels.x, pixels.y, pixels.width, pixels.height);
        view.camera = pane.camera;
        draw_view(view, pixels.width, pixels.height);
    }
}

/// Draws a frame as its camera sees it into a viewport of width x height pixels.
void SceneRenderer::draw_view(const app::Frame& frame, int width, int height) const
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    set_camera(frame.camera, width, height);
    place_lights();
    surroundings_.draw_sky(frame.camera);
    if (frame.ground) {
        surroundings_.draw_ground(frame);
        draw_shadow(frame, *assets_, tank_lists_);
    }
    draw_tanks(frame);
    draw_spheres(frame, shapes_);
    draw_markers(frame, shapes_, height);
    particle_drawing_.draw(frame, height);
    if (frame.reticle) {
        draw_reticle(frame.camera, height);
    }
}

void SceneRenderer::draw_tanks(const app::Frame& frame) const
{
    use_tank_material();
    const Enabled lighting(GL_LIGHTING);
    const Enabled texture(GL_TEXTURE_2D);
    const Edges edges(frame.wireframe);
    glBindTexture(GL_TEXTURE_2D, texture_);
    std::optional<Enabled> culling;
    if (assets_->is_one_sided) {
        culling.emplace(GL_CULL_FACE);
    }
    for (const app::TankInFrame& tank : frame.tanks) {
        const TankDrawing drawing(tank_lists_, assets_->layout_of(tank.level), tank.joints, frame.parts);
        const glm::vec3 position(tank.position);
        if (tank.level == lod::Level::low && assets_->has_low_model) {
            drawing.draw_tank_low(position.x, position.y, position.z);
        } else {
            drawing.draw_tank(position.x, position.y, position.z);
        }
    }
}

} // namespace scene
