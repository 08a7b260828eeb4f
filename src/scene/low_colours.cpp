#include "scene/low_colours.h"

#include <array>

namespace scene {
namespace {

// What the high tank's picture shows on average where the low one's shows the mesh, by the handout's camera
// and from all around: (93, 90, 72) for the body, (91, 87, 70), (105, 96, 75), (74, 75, 65) and (72, 72, 57).
// Then up to 6 apart from each other, so that the parts can be told where no light shapes them.
constexpr std::array<Rgb, tank::MESH_KIND_COUNT> LOW_COLOURS = {{
    {90, 88, 70},  // body
    {97, 92, 74},  // turret
    {109, 99, 78}, // main gun
    {70, 71, 62},  // secondary gun
    {66, 66, 52},  // wheel
}};

} // namespace

Rgb low_colour(tank::MeshKind mesh)
{
    return LOW_COLOURS[tank::index_of(mesh)];
}

} // namespace scene
