#include "scene/particles/particle_quads.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace scene {
namespace {

constexpr double MIN_WIDTH = 1.5; // pixels

/// A streak that is shorter than this part of its width is a dot.
constexpr float MIN_STREAK = 0.05f;

} // namespace

ParticleQuads::ParticleQuads(const app::CameraView& camera, int window_height) : eye_(camera.eye)
{
    const app::ViewAxes axes = app::view_axes(camera);
    right_ = glm::vec3(axes.right);
    up_ = glm::vec3(axes.up);
    forward_ = glm::vec3(axes.forward);
    least_width_per_depth_ = static_cast<float>(MIN_WIDTH * axes.heights_per_depth / window_height);
}

ParticleQuad ParticleQuads::quad(const particles::ParticleView& view, std::size_t i) const
{
    const glm::vec3 head = view.position(i);
    const float size = view.size(i);
    const float width = std::max(size, least_width_per_depth_ * glm::dot(head - eye_, forward_));
    ParticleQuad quad{head, right_ * (0.5f * width), up_ * (0.5f * width),
                      width > size ? size / width : 1.0f};
    if (view.texture == particles::TextureKind::streak) {
        const glm::vec3 way = head - view.streak_end(i);
        const glm::vec3 side = glm::cross(way, eye_ - head);
        const float length = glm::length(way);
        const float side_length = glm::length(side);
        if (length > MIN_STREAK * width && side_length > 0.0f) {
            quad.centre = head - 0.5f * way;
            quad.across = side * (0.5f * width / side_length);
            quad.along = way * (0.5f + 0.5f * width / length);
        }
    }
    return quad;
}

} // namespace scene
