#pragma once

#include "legacygl/state/state_field.h"

#include <GL/gl.h>

#include <array>

namespace legacygl {

struct Context;

/// What glGet* answers: up to 16 values, and what they mean when they are converted.
struct QueryValue
{
    /// As in StateField, but numbers of every kind are held as doubles.
    enum class Kind : std::uint8_t
    {
        boolean,
        integer,
        real,
        fraction ///< A colour, a normal or a depth: 1 becomes the greatest integer.
    };
    Kind kind = Kind::integer;
    int count = 0; ///< 0: the name is not known.
    std::array<double, 16> values{};

    QueryValue() = default;
    QueryValue(Kind k, double value) : kind(k), count(1), values{value} {}
    /// A variable's value. It is not opaque.
    explicit QueryValue(const StateField& field);
    static QueryValue boolean(bool value) { return {Kind::boolean, value ? 1.0 : 0.0}; }
    static QueryValue integer(double value) { return {Kind::integer, value}; }
};

/// Returns the value of a state variable (OpenGL 1.5, chapter 6.2), for every form of glGet.
QueryValue query(const Context& gl, GLenum name);

} // namespace legacygl
