#pragma once

#include <GL/gl.h>
#include <glm/vec4.hpp>

namespace legacygl {

/// The stencil test (OpenGL 1.5, table 6.18).
struct StencilState
{
    bool enabled = false;
    GLenum func = GL_ALWAYS;
    GLint reference = 0;
    GLuint value_mask = 0xff;
    GLenum fail = GL_KEEP;
    GLenum depth_fail = GL_KEEP;
    GLenum depth_pass = GL_KEEP;
    GLuint write_mask = 0xff;
    bool operator==(const StencilState&) const = default;
};

/// Blending (OpenGL 1.5, table 6.19).
struct BlendState
{
    bool enabled = false;
    GLenum source_rgb = GL_ONE;
    GLenum destination_rgb = GL_ZERO;
    GLenum source_alpha = GL_ONE;
    GLenum destination_alpha = GL_ZERO;
    GLenum equation = GL_FUNC_ADD; ///< Of the colours.
    GLenum equation_alpha = GL_FUNC_ADD;
    glm::vec4 color{0, 0, 0, 0};
    bool operator==(const BlendState&) const = default;
    /// Whether colours are weighed by the constant colour and by the constant alpha at once. WebGL refuses
    /// that, so that the source's weight is the shader's to give.
    bool weighs_by_both_constants() const
    {
        const auto by_color = [](GLenum f) {
            return f == GL_CONSTANT_COLOR || f == GL_ONE_MINUS_CONSTANT_COLOR;
        };
        const auto by_alpha = [](GLenum f) {
            return f == GL_CONSTANT_ALPHA || f == GL_ONE_MINUS_CONSTANT_ALPHA;
        };
        return enabled && ((by_color(source_rgb) && by_alpha(destination_rgb)) ||
                           (by_alpha(source_rgb) && by_color(destination_rgb)));
    }
};

} // namespace legacygl
