#pragma once

#include <GL/gl.h>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace legacygl {

/// A variable of the state, seen as glGet and glPushAttrib see it: where it is and what its values mean.
struct StateField
{
    enum class Kind : std::uint8_t
    {
        boolean,
        signed_integer,
        unsigned_integer, ///< also every GLenum
        unsigned_short,
        real,
        fraction,        ///< A colour, a normal or a depth: 1 becomes the greatest integer.
        double_fraction, ///< The same, held as a GLdouble.
        opaque           ///< Saved and restored as a whole, never asked for by one name.
    };
    Kind kind;
    int count; ///< Values; 0 for an opaque field.
    void* data;
    std::size_t size; ///< Bytes.

    StateField(bool& value) : StateField(Kind::boolean, 1, value) {}
    StateField(GLint& value) : StateField(Kind::signed_integer, 1, value) {}
    StateField(GLuint& value) : StateField(Kind::unsigned_integer, 1, value) {}
    StateField(GLushort& value) : StateField(Kind::unsigned_short, 1, value) {}
    StateField(GLfloat& value) : StateField(Kind::real, 1, value) {}
    StateField(glm::vec4& value) : StateField(Kind::real, 4, value) {}
    template <std::size_t N>
    StateField(std::array<bool, N>& values) : StateField(Kind::boolean, static_cast<int>(N), values)
    {}
    template <std::size_t N>
    StateField(std::array<GLenum, N>& values)
        : StateField(Kind::unsigned_integer, static_cast<int>(N), values)
    {}
    template <std::size_t N>
    StateField(std::array<GLfloat, N>& values) : StateField(Kind::real, static_cast<int>(N), values)
    {}
    template <std::size_t N>
    StateField(std::array<GLint, N>& values) : StateField(Kind::signed_integer, static_cast<int>(N), values)
    {}

    static StateField fraction(GLfloat& value) { return {Kind::fraction, 1, value}; }
    static StateField fraction(GLdouble& value) { return {Kind::double_fraction, 1, value}; }
    static StateField fraction(glm::vec4& value) { return {Kind::fraction, 4, value}; }
    template <std::size_t N> static StateField fraction(std::array<GLfloat, N>& values)
    {
        return {Kind::fraction, static_cast<int>(N), values};
    }
    /// The first three values of a normal, which is held as four.
    static StateField normal(glm::vec4& value) { return {Kind::fraction, 3, value}; }
    template <class T> static StateField opaque(T& value) { return {Kind::opaque, 0, value}; }

private:
    template <class T> StateField(Kind k, int n, T& value) : kind(k), count(n), data(&value), size(sizeof(T))
    {
        static_assert(std::is_trivially_copyable_v<T>);
    }
};

} // namespace legacygl
