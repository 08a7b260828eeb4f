#pragma once

#include "app/view/camera_view.h"
#include "particles/particle_view.h"

#include <cstddef>
#include <glm/vec3.hpp>

namespace scene {

/// A particle as a rectangle that faces the eye. Metres, in the world.
struct ParticleQuad
{
    glm::vec3 centre;
    glm::vec3 across; ///< half its width
    glm::vec3 along;  ///< half its length, towards its head
    float opacity;    ///< 1, or less where it is drawn wider than it is
};

/// Makes rectangles of particles for one camera.
class ParticleQuads
{
public:
    /// window_height: pixels.
    ParticleQuads(const app::CameraView& camera, int window_height);

    /// Returns particle i of a view: a dot as a square, a streak from its end to its head with half its width
    /// beyond both. What is narrower than a pixel and a half is drawn so wide, and the fainter for it: else
    /// it would come and go between the pixels.
    ParticleQuad quad(const particles::ParticleView& view, std::size_t i) const;

private:
    glm::vec3 eye_;
    glm::vec3 right_;
    glm::vec3 up_;
    glm::vec3 forward_;
    float least_width_per_depth_;
};

} // namespace scene
