#pragma once

#include "tank/layout.h"
#include "tank/mesh_box.h"

namespace tank {

/// Returns the boxes of the lab's own meshes, in their units: what tells them from any others.
/// Measured on the handout's files, which are not ours to ship.
MeshBoxes original_boxes();

/// Returns the layout that assembles the lab's own high meshes, in their units, hull on the ground.
/// The gun's mesh, whose origin is far off, is brought to its trunnion, and the wheels turn about their
/// axles. roof: of the turret's mesh, on which the secondary gun stands. The lab gives no pivots: these make
/// the handout's meshes fit.
Layout original_layout(const TurretRoof& roof);

/// Returns the same for the low meshes: their wheels stand further out, or they hide inside the low body.
Layout original_low_layout(const TurretRoof& roof);

} // namespace tank
