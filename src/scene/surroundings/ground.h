#pragma once

namespace scene {

/// How dark a line of draw_grid is in its middle, 0 to 1.
inline constexpr double GRID_OPACITY = 0.08;

/// Draws the earth at y = 0: a disc of radius 1 around the origin that fades out into the haze at its rim.
/// For a place under the eye, as wide as the eye sees, lit, blended and without writing depth, so that the
/// grid can lie in the same plane.
void draw_earth();

/// Draws a grid of faint lines at y = 0, `spacing` metres apart and so many to each side of the origin,
/// where they fade out. It is meant to be drawn once or several times over, the more the darker.
/// For after the earth, blended, without lighting and without writing depth.
void draw_grid(int spacing, int lines);

/// Draws the soft dark patch a tank's hull leaves on the ground under it: its shadow from the whole sky.
/// In the body's frame; otherwise as the grid.
void draw_contact_shadow();

} // namespace scene
