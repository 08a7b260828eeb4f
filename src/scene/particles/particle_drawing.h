#pragma once

#include "app/view/frame.h"
#include "particles/particle_view.h"
#include "scene/particles/particle_quads.h"

#include <cstddef>
#include <vector>

namespace scene {

/// Draws particles as textured quads that face the eye, from vertex arrays.
/// What it makes belongs to the context that is current when it loads.
class ParticleDrawing
{
public:
    /// Uploads the particles' textures and makes room for their vertices.
    void load();

    /// Draws all particles of a frame; the modelview matrix is the view. After everything that hides what is
    /// behind it. window_height: pixels. Allocates nothing, however many there are.
    void draw(const app::Frame& frame, int window_height) const;

private:
    /// A corner as GL_T2F_C4UB_V3F has it.
    struct Vertex
    {
        float s, t;
        particles::Rgba colour;
        float x, y, z;
    };

    void draw_view(const particles::ParticleView& view, const ParticleQuads& quads) const;
    void put(std::size_t place, const ParticleQuad& quad, particles::Rgba colour) const;

    unsigned dot_texture_ = 0;
    unsigned streak_texture_ = 0;
    /// Four for each particle that is given to OpenGL at once; where to write a batch while it is drawn.
    mutable std::vector<Vertex> vertices_;
};

} // namespace scene
