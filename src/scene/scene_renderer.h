#pragma once

#include "app/view/frame.h"
#include "assets/assets.h"
#include "scene/drawing/shapes.h"
#include "scene/particles/particle_drawing.h"
#include "scene/surroundings/surroundings.h"
#include "scene/tank/tank_lists.h"

#include <string>

namespace scene {

/// Draws frames of the app with OpenGL 1.x. All it makes belongs to the context that is current when it
/// loads, and goes with it; that context must be current whenever it draws.
class SceneRenderer
{
public:
    /// Compiles the display lists, uploads the texture and sets what stays the same for every frame.
    /// assets: must outlive this renderer. Call it once.
    /// Returns "" or a sentence that says what OpenGL refused.
    std::string load(const assets::Assets& assets);

    /// Puts another tank in the place of the one before, and deletes what that had. `assets` must outlive
    /// this renderer, or the next call of this. Returns "" or a sentence that says what OpenGL refused; call
    /// it again then, with what it takes.
    std::string load_tank(const assets::Assets& assets);

    /// Draws a frame into a window of width x height pixels, both at least 1.
    /// Allocates nothing and compiles no list. Precondition: load() returned "".
    void draw(const app::Frame& frame, int width, int height) const;

    /// Returns the data of the tank that was loaded last. Precondition: one was.
    const assets::Assets& assets() const { return *assets_; }

    /// Returns the display lists of the tank and of spheres, for those who check what was drawn.
    const TankLists& tank_lists() const { return tank_lists_; }
    const Shapes& shapes() const { return shapes_; }

private:
    void draw_view(const app::Frame& frame, int width, int height) const;
    void draw_tanks(const app::Frame& frame) const;

    const assets::Assets* assets_ = nullptr;
    unsigned texture_ = 0;
    TankLists tank_lists_;
    Surroundings surroundings_;
    Shapes shapes_;
    ParticleDrawing particle_drawing_;
};

} // namespace scene
