#include "scene/particles/particle_drawing.h"

#include "scene/drawing/scoped_state.h"
#include "scene/drawing/texture.h"
#include "scene/particles/particle_textures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <GL/gl.h>

namespace scene {
namespace {

/// So many particles are given to OpenGL at once: enough to make a call cheap, few enough to stay in a cache.
constexpr std::size_t MAX_AT_ONCE = 2048;

} // namespace

void ParticleDrawing::load()
{
    dot_texture_ = upload_texture(soft_dot_image());
    streak_texture_ = upload_texture(streak_image());
    vertices_.resize(4 * MAX_AT_ONCE);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const std::size_t corner = i % 4; // anticlockwise from the lower left one
        vertices_[i].s = corner == 1 || corner == 2 ? 1.0f : 0.0f;
        vertices_[i].t = corner >= 2 ? 1.0f : 0.0f;
    }
}

void ParticleDrawing::draw(const app::Frame& frame, int window_height) const
{
    if (frame.particles.empty()) {
        return;
    }
    const ParticleQuads quads(frame.camera, window_height);
    const Enabled texture(GL_TEXTURE_2D);
    glInterleavedArrays(GL_T2F_C4UB_V3F, 0, vertices_.data());
    for (const particles::ParticleView& view : frame.particles) {
        const Blended blended(view.blending == particles::Blending::additive ? GL_ONE
                                                                             : GL_ONE_MINUS_SRC_ALPHA);
        glBindTexture(GL_TEXTURE_2D,
                      view.texture == particles::TextureKind::streak ? streak_texture_ : dot_texture_);
        draw_view(view, quads);
    }
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void ParticleDrawing::draw_view(const particles::ParticleView& view, const ParticleQuads& quads) const
{
    for (std::size_t first = 0; first < view.count(); first += MAX_AT_ONCE) {
        const std::size_t count = std::min(MAX_AT_ONCE, view.count() - first);
        for (std::size_t i = 0; i < count; ++i) {
            put(i, quads.quad(view, first + i), view.colour(first + i));
        }
        glDrawArrays(GL_QUADS, 0, static_cast<GLsizei>(4 * count));
    }
}

/// Writes a quad into the place of a particle of the batch.
void ParticleDrawing::put(std::size_t place, const ParticleQuad& quad, particles::Rgba colour) const
{
    colour.alpha = static_cast<std::uint8_t>(std::lround(static_cast<float>(colour.alpha) * quad.opacity));
    const glm::vec3 corners[] = {
        quad.centre - quad.across - quad.along, quad.centre + quad.across - quad.along,
        quad.centre + quad.across + quad.along, quad.centre - quad.across + quad.along};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        Vertex& vertex = vertices_[4 * place + corner];
        vertex.colour = colour;
        vertex.x = corners[corner].x;
        vertex.y = corners[corner].y;
        vertex.z = corners[corner].z;
    }
}

} // namespace scene
