#pragma once

namespace scene {

/// Draws the earth at y = 0: a disc around the origin that fades out into the haze at its rim.
/// Draw it lit, blended and without writing depth, so that the grid can lie in the same plane.
void draw_earth();

/// Draws a grid with a line each metre and a stronger one every five, fading out with the distance from
/// the origin. Draw it after the ground, blended, without lighting and without writing depth.
void draw_metre_grid();

/// Draws the soft dark patch a tank's hull leaves on the ground under it: the hull's shadow from the sky
/// all around. In the body's frame. Draw it as the grid.
void draw_contact_shadow();

} // namespace scene
