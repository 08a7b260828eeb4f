#pragma once

#include <GL/gl.h>

#include <array>

namespace legacygl {

struct Context;

/// What glGet* answers: up to 16 values, and what they mean when they are converted.
struct QueryValue
{
    enum class Kind
    {
        boolean,
        integer,
        real,
        normalized
    }; ///< normalized: a colour, normal or depth
    Kind kind = Kind::integer;
    int count = 0; ///< 0: the name is not known.
    std::array<double, 16> values{};
};

/// Returns the value of a state variable (OpenGL 1.5, chapter 6.2), for every form of glGet.
QueryValue query(const Context& gl, GLenum name);

} // namespace legacygl
