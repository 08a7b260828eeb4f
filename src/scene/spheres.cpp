#include "scene/spheres.h"

#include "scene/level_colours.h"
#include "scene/materials.h"
#include "scene/scoped_state.h"

#include <cstdint>

#include <GL/gl.h>

namespace scene {
namespace {

// The tank has to stay readable through four layers: back and front of the root and of a part.
constexpr std::uint8_t ROOT_OPACITY = 40; // of 255
constexpr std::uint8_t PART_OPACITY = 70;
constexpr std::uint8_t WIRE_OPACITY = 150;

/// Draws the inner side of a sphere, seen from outside its far half, or the outer one.
void draw_side(const app::SphereInFrame& sphere, GLenum culled, const Shapes& shapes)
{
    const Rgb colour = level_colour(sphere.is_root);
    glColor4ub(colour.red, colour.green, colour.blue, sphere.is_root ? ROOT_OPACITY : PART_OPACITY);
    glCullFace(culled);
    shapes.draw_sphere(sphere.centre, sphere.radius);
    glCullFace(GL_BACK);
}

void draw_wire(const app::SphereInFrame& sphere, const Shapes& shapes)
{
    const Disabled lighting(GL_LIGHTING);
    const Rgb colour = level_colour(sphere.is_root);
    glColor4ub(colour.red, colour.green, colour.blue, WIRE_OPACITY);
    shapes.draw_wire_sphere(sphere.centre, sphere.radius);
}

} // namespace

void draw_spheres(const app::Frame& frame, const Shapes& shapes)
{
    const Blended blended;
    use_plain_material();
    const Enabled lighting(GL_LIGHTING);
    const Enabled colour_material(GL_COLOR_MATERIAL);
    const Enabled culling(GL_CULL_FACE);
    // The root contains the others: its far half is behind all of them, its near half before.
    for (const app::SphereInFrame& sphere : frame.used_spheres()) {
        if (sphere.is_root && sphere.is_penetrated) {
            draw_side(sphere, GL_FRONT, shapes);
        }
    }
    for (const app::SphereInFrame& sphere : frame.used_spheres()) {
        if (!sphere.is_penetrated) {
            draw_wire(sphere, shapes);
        } else if (!sphere.is_root) {
            draw_side(sphere, GL_FRONT, shapes);
            draw_side(sphere, GL_BACK, shapes);
        }
    }
    for (const app::SphereInFrame& sphere : frame.used_spheres()) {
        if (sphere.is_root && sphere.is_penetrated) {
            draw_side(sphere, GL_BACK, shapes);
        }
    }
}

} // namespace scene
