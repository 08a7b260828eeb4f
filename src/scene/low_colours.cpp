#include "scene/low_colours.h"

#include <array>

namespace scene {
namespace {

// What the high tank's picture shows on average where the low one's shows the mesh, from all around: (85, 81,
// 65) for the body, (84, 81, 66), (95, 92, 70), (73, 74, 65) and (65, 66, 54). Then up to 4 apart from each
// other, so that the parts can be told where no light shapes them.
constexpr std::array<Rgb, tank::MESH_KIND_COUNT> LOW_COLOURS = {{
    {83, 79, 63}, // body
    {88, 84, 68}, // turret
    {97, 93, 71}, // main gun
    {72, 73, 64}, // secondary gun
    {63, 64, 52}, // wheel
}};

} // namespace

Rgb low_colour(tank::MeshKind mesh)
{
    return LOW_COLOURS[tank::index_of(mesh)];
}

} // namespace scene
