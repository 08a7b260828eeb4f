#include "scene/markers/spheres.h"

#include "scene/drawing/materials.h"
#include "scene/drawing/scoped_state.h"
#include "scene/markers/level_colours.h"

#include <cstdint>

#include <GL/gl.h>

namespace scene {
namespace {

/// How much of what is behind a sphere it hides, of 255. The tank has to stay readable through four faces:
/// back and front of the root and of a part.
struct Opacity
{
    std::uint8_t face;
    std::uint8_t wire_on_face; ///< by its curves a transparent disc is seen to be a sphere
    std::uint8_t wire;         ///< of a sphere that is not penetrated
};
constexpr Opacity ROOT_OPACITY = {.face = 30, .wire_on_face = 60, .wire = 150};
constexpr Opacity PART_OPACITY = {.face = 44, .wire_on_face = 60, .wire = 110};

void set_colour(const app::SphereInFrame& sphere, std::uint8_t Opacity::* use)
{
    const Rgb colour = level_colour(sphere.is_root);
    glColor4ub(colour.red, colour.green, colour.blue, (sphere.is_root ? ROOT_OPACITY : PART_OPACITY).*use);
}

/// Draws the inner side of a sphere, which is its far half seen from outside, or the outer one.
void draw_side(const app::SphereInFrame& sphere, GLenum culled, const Shapes& shapes)
{
    const Enabled lighting(GL_LIGHTING);
    set_colour(sphere, &Opacity::face);
    glCullFace(culled);
    shapes.draw_sphere(sphere.centre, sphere.radius);
    glCullFace(GL_BACK);
}

void draw_wire(const app::SphereInFrame& sphere, std::uint8_t Opacity::* use, const Shapes& shapes)
{
    set_colour(sphere, use);
    shapes.draw_wire_sphere(sphere.centre, sphere.radius);
}

} // namespace

void draw_spheres(const app::Frame& frame, const Shapes& shapes)
{
    if (frame.spheres.empty()) {
        return;
    }
    const Blended blended;
    use_plain_material();
    const Enabled colour_material(GL_COLOR_MATERIAL);
    const Enabled culling(GL_CULL_FACE);
    // The root contains the others: its far half is behind all of them, its near half before.
    for (const app::SphereInFrame& sphere : frame.spheres) {
        if (sphere.is_root && sphere.is_penetrated) {
            draw_side(sphere, GL_FRONT, shapes);
        }
    }
    for (const app::SphereInFrame& sphere : frame.spheres) {
        if (!sphere.is_penetrated) {
            draw_wire(sphere, &Opacity::wire, shapes);
        } else if (!sphere.is_root) {
            draw_side(sphere, GL_FRONT, shapes);
            draw_wire(sphere, &Opacity::wire_on_face, shapes);
            draw_side(sphere, GL_BACK, shapes);
        }
    }
    for (const app::SphereInFrame& sphere : frame.spheres) {
        if (sphere.is_root && sphere.is_penetrated) {
            draw_wire(sphere, &Opacity::wire_on_face, shapes);
            draw_side(sphere, GL_BACK, shapes);
        }
    }
}

} // namespace scene
