#pragma once

#include "legacygl/backend/stencil_and_blend.h"

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <array>

namespace legacygl {

/// OpenGL 1.5, table 6.10.
struct FogState
{
    bool enabled = false;
    GLenum mode = GL_EXP;
    GLenum coordinate_source = GL_FRAGMENT_DEPTH;
    glm::vec4 color{0, 0, 0, 0};
    GLfloat density = 1;
    GLfloat start = 0;
    GLfloat end = 1;
    GLfloat index = 0;
};

/// OpenGL 1.5, tables 6.18 to 6.20.
struct FragmentState
{
    bool depth_test = false;
    GLenum depth_func = GL_LESS;
    bool scissor_test = false;
    std::array<GLint, 4> scissor_box{};
    bool alpha_test = false;
    GLenum alpha_func = GL_ALWAYS;
    GLfloat alpha_reference = 0;
    StencilState stencil;
    BlendState blend;
    bool dither = true;
    bool color_logic_op = false;
    bool index_logic_op = false; ///< Of colour indices, which nothing is drawn with.
    GLenum logic_op = GL_COPY;
    /// Returns the logic op that combines fragments with what is there; GL_COPY: none does.
    GLenum effective_logic_op() const { return color_logic_op ? logic_op : GLenum{GL_COPY}; }
    bool depth_mask = true;
    std::array<bool, 4> color_mask{true, true, true, true};
    glm::vec4 clear_color{0, 0, 0, 0};
    GLdouble clear_depth = 1;
    GLint clear_stencil = 0;
    glm::vec4 clear_accumulation{0, 0, 0, 0};
    GLenum draw_buffer = GL_BACK;
    GLenum read_buffer = GL_BACK;

    /// Which colour buffers are drawn into, by the name that glDrawBuffer was given.
    bool draws_front() const { return draw_buffer != GL_NONE && !draws_back_only(); }
    bool draws_back() const
    {
        return draws_back_only() || draw_buffer == GL_LEFT || draw_buffer == GL_FRONT_AND_BACK;
    }
    bool reads_front() const { return read_buffer != GL_BACK && read_buffer != GL_BACK_LEFT; }

private:
    bool draws_back_only() const { return draw_buffer == GL_BACK || draw_buffer == GL_BACK_LEFT; }
};

} // namespace legacygl
