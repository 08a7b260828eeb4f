#include "scene/surroundings/surroundings.h"

#include "scene/drawing/degrees.h"
#include "scene/drawing/materials.h"
#include "scene/drawing/scoped_state.h"
#include "scene/surroundings/ground.h"
#include "scene/surroundings/sky.h"

#include <algorithm>
#include <cmath>

#include <GL/gl.h>

namespace scene {
namespace {

/// Says at which distances from the eye to the tank a grid is drawn in full and no longer at all, metres, and
/// how many times over it is drawn in full. Lines that are further away than that run together.
struct GridFade
{
    double full_to;
    double gone_at;
    int most_calls;
};
constexpr GridFade METRE_GRID_FADE = {.full_to = 15.0, .gone_at = 45.0, .most_calls = 3};
constexpr GridFade FIVE_METRE_GRID_FADE = {.full_to = 60.0, .gone_at = 200.0, .most_calls = 5};

int grid_calls(const GridFade& fade, double distance)
{
    const double share = (fade.gone_at - distance) / (fade.gone_at - fade.full_to);
    return static_cast<int>(std::ceil(std::clamp(share, 0.0, 1.0) * fade.most_calls));
}

} // namespace

bool Surroundings::load()
{
    first_list_ = glGenLists(LIST_COUNT);
    if (first_list_ == 0) {
        return false;
    }
    const auto compile = [this](List list, auto draw) {
        glNewList(first_list_ + list, GL_COMPILE);
        draw();
        glEndList();
    };
    compile(SKY, draw_sky_dome);
    compile(EARTH, draw_earth);
    compile(METRE_GRID, [] { draw_grid(1, 40); });
    compile(FIVE_METRE_GRID, [] { draw_grid(5, 16); });
    compile(CONTACT_SHADOW, draw_contact_shadow);
    return true;
}

void Surroundings::draw_sky(const app::CameraView& camera) const
{
    const double radius = 0.5 * (camera.near_plane + camera.far_plane); // any between would do
    const Disabled depth_test(GL_DEPTH_TEST);
    const PushedMatrix matrix;
    glTranslated(camera.eye.x, camera.eye.y, camera.eye.z);
    glScaled(radius, radius, radius);
    glCallList(first_list_ + SKY);
}

void Surroundings::draw_ground(const app::Frame& frame) const
{
    const Blended blended;
    draw_earth_under(frame.camera);
    draw_grids(frame);
    if (frame.wireframe || !frame.parts.contains(tank::index_of(tank::Part::body))) {
        return; // no hull stands over the ground
    }
    for (const app::TankInFrame& tank : frame.tanks) {
        const PushedMatrix matrix;
        glTranslated(tank.position.x, tank.position.y, tank.position.z);
        glRotatef(degrees(tank.joints[tank::Joint::heading]), 0.0f, 1.0f, 0.0f);
        glCallList(first_list_ + CONTACT_SHADOW);
    }
}

void Surroundings::draw_earth_under(const app::CameraView& camera) const
{
    // The haze is as far from the eye wherever it goes; of one colour, the earth can come along.
    const double radius = 0.99 * camera.far_plane;
    use_plain_material();
    const Enabled lighting(GL_LIGHTING);
    const Enabled colour_material(GL_COLOR_MATERIAL);
    const PushedMatrix matrix;
    glTranslated(camera.eye.x, 0.0, camera.eye.z);
    glScaled(radius, 1.0, radius);
    glCallList(first_list_ + EARTH);
}

void Surroundings::draw_grids(const app::Frame& frame) const
{
    const glm::dvec3 offset = frame.camera.eye - frame.camera.centre;
    const double distance = std::sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z);
    const PushedMatrix matrix;
    // Around what is looked at, but by whole lines: they stay where they are in the world.
    glTranslated(5.0 * std::round(frame.camera.centre.x / 5.0), 0.0,
                 5.0 * std::round(frame.camera.centre.z / 5.0));
    for (int call = grid_calls(METRE_GRID_FADE, distance); call > 0; --call) {
        glCallList(first_list_ + METRE_GRID);
    }
    for (int call = grid_calls(FIVE_METRE_GRID_FADE, distance); call > 0; --call) {
        glCallList(first_list_ + FIVE_METRE_GRID);
    }
}

} // namespace scene
