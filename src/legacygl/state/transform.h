#pragma once

#include "legacygl/state/matrix.h"
#include "legacygl/vertex/format.h"

#include <GL/gl.h>

#include <array>
#include <vector>

namespace legacygl {

/// A stack of matrices, at least one deep.
class MatrixStack
{
public:
    explicit MatrixStack(std::size_t capacity) : capacity_(capacity)
    {
        matrices_.reserve(capacity);
        matrices_.emplace_back();
    }
    Matrix& top() { return matrices_.back(); }
    const Matrix& top() const { return matrices_.back(); }
    /// Duplicates the top. Returns false when the stack is full.
    bool push()
    {
        if (matrices_.size() == capacity_) {
            return false;
        }
        matrices_.push_back(matrices_.back());
        return true;
    }
    /// Returns false when only one matrix is left.
    bool pop()
    {
        if (matrices_.size() == 1) {
            return false;
        }
        matrices_.pop_back();
        return true;
    }
    std::size_t depth() const { return matrices_.size(); }
    std::size_t capacity() const { return capacity_; }

private:
    std::size_t capacity_;
    std::vector<Matrix> matrices_;
};

constexpr int CLIP_PLANE_COUNT = 6;

/// A user clip plane (OpenGL 1.5, 2.12); the equation is in eye coordinates.
struct ClipPlane
{
    bool enabled = false;
    glm::vec4 equation{0, 0, 0, 0};
};

/// OpenGL 1.5, table 6.9.
struct TransformState
{
    MatrixStack modelview{32};
    MatrixStack projection{32};
    std::array<MatrixStack, TEXTURE_UNIT_COUNT> texture{MatrixStack(32), MatrixStack(32)};
    GLenum matrix_mode = GL_MODELVIEW;
    std::array<GLint, 4> viewport{};
    std::array<GLfloat, 2> depth_range{0, 1};
    bool normalize = false;
    bool rescale_normal = false;
    std::array<ClipPlane, CLIP_PLANE_COUNT> clip_planes;

    bool clips() const
    {
        for (const ClipPlane& plane : clip_planes) {
            if (plane.enabled) {
                return true;
            }
        }
        return false;
    }
};

} // namespace legacygl
