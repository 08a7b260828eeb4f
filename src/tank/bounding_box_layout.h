#pragma once

#include "tank/layout.h"
#include "tank/mesh_box.h"

namespace tank {

/// Returns a layout for meshes of which nothing is known but their boxes, in their units: Y up, gun along +Z.
/// Where a mesh lies in its file makes no difference, except that a turret whose origin lies in the middle
/// half of its box turns about it. The proportions are those that the two known tanks, ours and the lab's,
/// have in common:
/// - The body is centred and stands on the ground.
/// - The turret's floor is at nine tenths of the body's height. Its axis is 1/27 of the body's length before
///   the body's middle, and 1/9 of the turret's length before the turret's, for the bustle behind it.
/// - The main gun's trunnion is at the turret's middle, 1/8 of the turret's length behind its front and a
///   tenth of that length above its floor; in the gun it is in the middle, 1/18 of its length from its end.
/// - The secondary gun stands on the roof, 1/6 of the turret's width to the right of the turret's axis and
///   1/9 of its length behind it, and turns about its rear end; there it pitches, too, at half its height, so
///   that no pitch sinks its rear into the roof.
/// - The wheels stand 1/20 of the body's height above the ground, for the track below them, and 1/30 of its
///   width within its sides, evenly from 4/5 to 1/5 of its length. They turn about their middle. Where the
///   origin of the wheel's mesh is at its +X side, that side is the hub and the other one is outside;
///   otherwise +X is outside.
/// Precondition: the boxes are finite.
Layout bounding_box_layout(const MeshBoxes& boxes, const TurretRoof& roof);

} // namespace tank
