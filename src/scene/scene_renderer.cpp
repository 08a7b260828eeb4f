#include "scene/scene_renderer.h"

#include "scene/draw_tank.h"
#include "scene/lights.h"
#include "scene/markers.h"
#include "scene/materials.h"
#include "scene/scoped_state.h"
#include "scene/shadow.h"
#include "scene/spheres.h"
#include "scene/texture.h"

#include <numbers>
#include <optional>

#include <GL/gl.h>
#include <GL/glu.h>

namespace scene {
namespace {

void set_camera(const app::CameraView& camera, int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(camera.field_of_view * 180.0 / std::numbers::pi,
                   static_cast<double>(width) / static_cast<double>(height), camera.near_plane,
                   camera.far_plane);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(camera.eye.x, camera.eye.y, camera.eye.z, camera.centre.x, camera.centre.y, camera.centre.z,
              camera.up.x, camera.up.y, camera.up.z);
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
    glClearColor(0.78f, 0.80f, 0.79f, 1.0f);
    set_up_lights();
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

std::string SceneRenderer::load(const app::Assets& assets)
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

std::string SceneRenderer::load_tank(const app::Assets& assets)
{
    assets_ = &assets;
    if (texture_ != 0) {
        glDeleteTextures(1, &texture_);
    }
    texture_ = upload_texture(assets.texture);
    const bool loaded = tank_lists_.load_tank_objs(assets.high, assets.track_links) &&
                        tank_lists_.load_low_detail_tank_objs(assets.low) &&
                        tank_lists_.load_shapes(assets.meshes(shadow_level(assets)));
    const GLenum error = glGetError();
    return loaded && error == GL_NO_ERROR ? "" : refusal(error);
}

void SceneRenderer::draw(const app::Frame& frame, int width, int height) const
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
    for (const app::TankInFrame& tank : frame.used_tanks()) {
        const TankDrawing drawing(tank_lists_, assets_->layout_of(tank.level), tank.joints, frame.parts);
        const glm::vec3 position(tank.position);
        if (tank.level == app::Level::low && assets_->has_low_model) {
            drawing.draw_tank_low(position.x, position.y, position.z);
        } else {
            drawing.draw_tank(position.x, position.y, position.z);
        }
    }
}

} // namespace scene
