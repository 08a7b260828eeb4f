#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace random_gl {

/// An OpenGL name and how it is written.
struct Name
{
    GLenum value;
    std::string text;
    operator GLenum() const { return value; }
};

/// Several numbers that a call gets by a pointer.
template <class T, std::size_t N> struct Values
{
    std::array<T, N> values;
    operator const T*() const { return values.data(); }
};

std::string written(const Name& name);
std::string written(float value);
std::string written(double value);
std::string written(int value);
std::string written(unsigned value);
inline std::string written(unsigned char value)
{
    return written(static_cast<unsigned>(value));
}
inline std::string written(unsigned short value)
{
    return written(static_cast<unsigned>(value));
}
template <class T, std::size_t N> std::string written(const Values<T, N>& values)
{
    std::string text;
    for (const T& value : values.values) {
        text += (text.empty() ? "" : ", ") + written(value);
    }
    return std::string("std::array{") + text + "}.data()";
}

/// A function and what it is called with. Made with braces, the arguments are evaluated from left to right.
template <class Function, class... Arguments> struct Call
{
    Call(const char* name, Function called, Arguments... with)
        : function_name(name), function(called), arguments(with...)
    {}
    const char* function_name;
    Function function;
    std::tuple<Arguments...> arguments;
};

/// A call of OpenGL: made by run, written as C++ by text.
struct Command
{
    std::string text;
    std::function<void()> run;
    /// The other one of a pair, such as glNewList and glEndList; itself when it stands alone.
    std::size_t partner;
    /// It and its partner stand and fall with what is between them: glBegin and glEnd.
    bool holds_together = false;
    /// Calls of one unit stand and fall together.
    std::size_t unit;
};

/// Calls of OpenGL as data, so that they can be made, written down, and made without some of them.
class Program
{
public:
    /// Adds a call; arguments are numbers, Names and Values. Returns its index.
    template <class Function, class... Arguments> std::size_t add(const Call<Function, Arguments...>& call)
    {
        std::string text;
        const auto write = [&](const auto&... arguments) {
            ((text += (text.empty() ? "" : ", ") + written(arguments)), ...);
        };
        std::apply(write, call.arguments);
        return add_command(call.function_name + ("(" + text + ");"),
                           [call] { std::apply(call.function, call.arguments); });
    }
    /// Says that two calls are a pair.
    void pair(std::size_t opening, std::size_t closing, bool holds_together);
    /// Makes the calls that follow one unit, until the next one begins or end_unit().
    void begin_unit();
    void end_unit() { unit_.reset(); }

    std::size_t size() const { return commands_.size(); }
    const std::vector<Command>& commands() const { return commands_; }

    /// Makes the calls of these indices, which ascend.
    void run(std::span<const std::size_t> kept) const;
    /// Makes the calls from an index on.
    void run(std::size_t from = 0) const;

    /// Returns indices without those from `from` up to `to` (places in kept) and what falls with them.
    std::vector<std::size_t> without(std::span<const std::size_t> kept, std::size_t from,
                                     std::size_t to) const;

private:
    std::size_t add_command(std::string text, std::function<void()> run);

    std::vector<Command> commands_;
    std::optional<std::size_t> unit_;
};

} // namespace random_gl
