#pragma once

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <array>

namespace legacygl {

/// OpenGL 1.5, table 6.13.
struct RasterState
{
    bool cull_face = false;
    GLenum cull_face_mode = GL_BACK;
    GLenum front_face = GL_CCW;
    GLfloat line_width = 1;
    GLfloat point_size = 1;
};

/// OpenGL 1.5, tables 6.18 to 6.20.
struct FragmentState
{
    bool depth_test = false;
    GLenum depth_func = GL_LESS;
    bool blend = false;
    GLenum blend_source = GL_ONE;
    GLenum blend_destination = GL_ZERO;
    bool dither = true;
    bool depth_mask = true;
    std::array<bool, 4> color_mask{true, true, true, true};
    glm::vec4 clear_color{0, 0, 0, 0};
    GLfloat clear_depth = 1;
    GLint clear_stencil = 0;
};

} // namespace legacygl
