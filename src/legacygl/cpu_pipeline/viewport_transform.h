#pragma once

#include "legacygl/state/transform.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace legacygl {

/// a · b + c, rounded once. Mesa's software renderer computes so where the processor can; the last bit of a
/// window coordinate decides whether a pixel on an edge is drawn.
inline float fused(float a, float b, float c)
{
    return static_cast<float>(static_cast<double>(a) * static_cast<double>(b) + static_cast<double>(c));
}

/// From clip to window coordinates and back (OpenGL 1.5, 2.11.1).
class ViewportTransform
{
public:
    explicit ViewportTransform(const TransformState& state)
    {
        for (int i = 0; i < 2; ++i) {
            scale_[i] = 0.5f * static_cast<float>(state.viewport[i + 2]);
            translate_[i] = scale_[i] + static_cast<float>(state.viewport[i]);
        }
        const double near_depth = static_cast<double>(state.depth_range[0]),
                     far_depth = static_cast<double>(state.depth_range[1]);
        scale_.z = static_cast<float>(0.5 * (far_depth - near_depth));
        translate_.z = static_cast<float>(0.5 * (far_depth + near_depth));
    }

    /// Returns that of a viewport which is larger by margin pixels to all sides.
    ViewportTransform grown(float margin) const
    {
        ViewportTransform larger = *this;
        larger.scale_.x += margin;
        larger.scale_.y += margin;
        return larger;
    }

    /// Returns pixels, the depth in [0, 1] and 1 / w.
    glm::vec4 window(const glm::vec4& clip) const
    {
        const float reciprocal = 1.0f / clip.w;
        return {fused(clip.x * reciprocal, scale_.x, translate_.x),
                fused(clip.y * reciprocal, scale_.y, translate_.y),
                fused(clip.z * reciprocal, scale_.z, translate_.z), reciprocal};
    }

    /// The same where Mesa's clipper made the vertex: there each operation is rounded.
    glm::vec4 window_of_cut(const glm::vec4& clip) const
    {
        const float reciprocal = 1.0f / clip.w;
        return {clip.x * reciprocal * scale_.x + translate_.x, clip.y * reciprocal * scale_.y + translate_.y,
                clip.z * reciprocal * scale_.z + translate_.z, reciprocal};
    }

    /// Returns the clip coordinates that a viewport grown by margin pixels to all sides maps to the window
    /// coordinates. The depth is kept in the clip volume.
    glm::vec4 clip(const glm::vec4& window, float margin) const
    {
        const float w = 1.0f / window.w;
        const float z = scale_.z != 0 ? (window.z - translate_.z) / scale_.z : 0;
        return {(window.x - translate_.x) / (scale_.x + margin) * w,
                (window.y - translate_.y) / (scale_.y + margin) * w,
                (z < -1  ? -1.0f
                 : z > 1 ? 1.0f
                         : z) *
                    w,
                w};
    }

    /// Returns clip coordinates within the view volume, with the same w, that window() maps onto the window
    /// coordinates, or as close to them as floats come. clip: where to begin.
    glm::vec4 clip_onto(const glm::vec4& window, glm::vec4 clip) const
    {
        for (int i = 0; i < 3; ++i) {
            if (scale_[i] == 0) {
                continue;
            }
            const auto miss = [&](float value) {
                return std::fabs(fused(value * (1.0f / clip.w), scale_[i], translate_[i]) - window[i]);
            };
            const float computed = (window[i] - translate_[i]) / scale_[i] * clip.w;
            if (!(miss(clip[i]) <= miss(computed))) {
                clip[i] = computed;
            }
            clip[i] = std::fmax(std::fmin(clip[i], clip.w), -clip.w);
            for (const float towards : {-clip.w, clip.w}) {
                for (float next = std::nextafter(clip[i], towards); miss(next) < miss(clip[i]);
                     next = std::nextafter(clip[i], towards)) {
                    clip[i] = next;
                }
            }
        }
        return clip;
    }

private:
    glm::vec3 scale_, translate_;
};

} // namespace legacygl
