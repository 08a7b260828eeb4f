#include "scene/low_colours.h"

#include <array>

namespace scene {
namespace {

// What the lit and textured mesh is on average, as pictures of the high tank from around show it: from far
// away an eye, and a pixel, takes in no more.
constexpr std::array<Rgb, tank::MESH_KIND_COUNT> LOW_COLOURS = {{
    {93, 92, 68}, // body
    {97, 97, 72}, // turret
    {88, 88, 66}, // main gun
    {62, 62, 54}, // secondary gun
    {74, 72, 60}, // wheel
}};

} // namespace

Rgb low_colour(tank::MeshKind mesh)
{
    return LOW_COLOURS[tank::index_of(mesh)];
}

} // namespace scene
