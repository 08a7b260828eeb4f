#pragma once

namespace scene {

/// Draws a dome of sky of radius 1 around the origin, lightest at the horizon.
/// For the start of a picture, centred on the eye, without lighting, texture, depth test and culling.
void draw_sky_dome();

} // namespace scene
