#pragma once

#include "app/view/frame.h"

namespace scene {

/// The sky and the ground around the tank, compiled once into display lists of the current context.
class Surroundings
{
public:
    /// Compiles the lists. Returns false when OpenGL has no names for lists left.
    bool load();

    /// Draws the sky around the eye; the modelview matrix is the view. Before everything else.
    void draw_sky(const app::CameraView& camera) const;

    /// Draws the ground, its grids and the tanks' shadows; the modelview matrix is the view.
    /// After the sky and before the tanks: the ground leaves no depth, so that what lies in its plane
    /// cannot fight with it. Nothing may hide behind the ground then, and nothing does: no eye is below it.
    void draw_ground(const app::Frame& frame) const;

private:
    void draw_earth_under(const app::CameraView& camera) const;
    void draw_grids(const app::Frame& frame) const;

    enum List : unsigned
    {
        SKY,
        EARTH,
        METRE_GRID,
        FIVE_METRE_GRID,
        CONTACT_SHADOW,
        LIST_COUNT
    };

    unsigned first_list_ = 0;
};

} // namespace scene
