#pragma once

#include "scene.h"

#include <GL/gl.h>

#include <string>

namespace oracle {

/// Tells one state variable of `count` values in every form of glGet.
inline void tell_state(const char* name, GLenum which, int count)
{
    GLboolean booleans[16] = {};
    GLint integers[16] = {};
    GLfloat floats[16] = {};
    GLdouble doubles[16] = {};
    glGetBooleanv(which, booleans);
    glGetIntegerv(which, integers);
    glGetFloatv(which, floats);
    glGetDoublev(which, doubles);
    std::string line = name;
    for (int i = 0; i < count; ++i) {
        line += (i ? " | " : ": ") + std::to_string(booleans[i]) + " " + std::to_string(integers[i]) + " " +
                std::to_string(floats[i]) + " " + std::to_string(doubles[i]);
    }
    for (unsigned code; (code = next_error()) != GL_NO_ERROR;) {
        line += " error " + std::to_string(code);
    }
    tell(line);
}

inline void tell_error(const std::string& what)
{
    tell(what + ": error " + std::to_string(next_error()));
}

} // namespace oracle

#define TELL_STATE(name, count) oracle::tell_state(#name, name, count)
