#pragma once

#include "app/view/frame.h"
#include "assets/assets.h"
#include "scene/tank/tank_lists.h"

namespace scene {

/// Draws the shadow that the sun throws of a frame's tanks on the ground, y = 0, with a soft edge that widens
/// with the height of what throws it; nothing where the target has no stencil. The modelview matrix is the
/// view. The stencil is 0 before. After the ground, which leaves no depth, and before the tanks: the shadow
/// leaves none either, so that nothing in the ground's plane can fight with it. It is thrown by the low
/// model's shapes, whatever is drawn: it does not change when the level does.
void draw_shadow(const app::Frame& frame, const assets::Assets& assets, const TankLists& lists);

/// Returns the meshes that TankLists::load_shapes takes for draw_shadow, and the level whose layout they
/// have.
lod::Level shadow_level(const assets::Assets& assets);

} // namespace scene
