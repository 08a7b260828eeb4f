#pragma once

#include "scenes/queries.h"

#include <GL/gl.h>

#include <string>
#include <vector>

namespace oracle {

/// Bytes that differ everywhere, the same on both sides.
inline std::vector<GLubyte> noise(std::size_t count)
{
    std::vector<GLubyte> bytes(count);
    unsigned state = 12345;
    for (GLubyte& b : bytes) {
        state = state * 1103515245u + 12345u;
        b = static_cast<GLubyte>(state >> 16);
    }
    return bytes;
}

inline void parameters(GLenum filter, GLenum wrap)
{
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
}

/// Draws a rectangle of the texture, its coordinates from `low` to `high`.
inline void quad(float x, float y, float width, float height, float low = 0, float high = 1)
{
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        glTexCoord2f(i % 2 ? high : low, i / 2 ? high : low);
        glVertex2f(x + (i % 2 ? width : 0), y + (i / 2 ? height : 0));
    }
    glEnd();
}

/// Mesa calls the format of a level that is not there GL_RGBA, the specification 1 (OpenGL 1.5, table 6.16):
/// only formats of levels that are there are told.
inline void tell_level(GLenum target, GLint level)
{
    GLint width = 0;
    glGetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &width);
    for (GLenum name : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_BORDER,
                        GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                        GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE}) {
        if (name == GL_TEXTURE_INTERNAL_FORMAT && width == 0) {
            continue;
        }
        GLint integer = -7;
        GLfloat real = -7;
        glGetTexLevelParameteriv(target, level, name, &integer);
        glGetTexLevelParameterfv(target, level, name, &real);
        tell(std::to_string(name) + " " + std::to_string(integer) + " " + std::to_string(real));
    }
    tell_error("level");
}

} // namespace oracle
