#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A stand-in for OpenGL that draws nothing and writes down what it is asked: linked instead of a library,
/// it defines the gl* and glu* functions that scene/ calls, and no others.
namespace recording_gl {

struct Call
{
    std::string name;
    std::vector<double> arguments;     ///< numbers; of a pointer, what it points to
    unsigned compiled_into;            ///< the list that was being compiled; 0: none
    std::vector<unsigned char> arrays; ///< of glDrawArrays: the vertices, as GL_T2F_C4UB_V3F has them
};

/// Forgets everything and answers as a fresh context does.
void reset();

/// What was called since reset() or take_calls().
const std::vector<Call>& calls();

/// Returns calls() and forgets them, but not the names that were given out.
std::vector<Call> take_calls();

/// Makes the functions write nothing down (true: they do, as after reset).
void record(bool on);

/// Makes glGenLists return 0 from now on.
void have_no_list_names();

/// Makes the target have no stencil from now on; it has 8 bits otherwise.
void have_no_stencil();

/// Makes the next glGetError return this.
void set_error(unsigned error);

/// The values of the state that switches neither on nor off, by the function that sets them.
using Settings = std::map<std::string, std::vector<double>>;

/// What the program sees when a list is called, or something is drawn without one: the modelview matrix, what
/// is enabled, and the settings.
struct ListCall
{
    unsigned list; ///< 0: glBegin or glDrawArrays
    glm::dmat4 modelview;
    std::vector<unsigned> enabled; ///< GLenum of what is on, sorted
    bool depth_writes;
    std::size_t stack_depth; ///< pushes that are not popped
    Settings settings;       ///< also the colour, under "colour": bytes, opaque unless it says so
    std::size_t call;        ///< its index among the calls

    bool is_enabled(unsigned capability) const;
};

/// What following a frame's calls gives.
struct Replay
{
    std::vector<ListCall> list_calls;
    std::vector<ListCall> direct_draws;                ///< by glBegin or glDrawArrays
    std::vector<glm::dmat4> light_positions_set_under; ///< the modelview at each GL_POSITION of a light
    std::size_t final_stack_depth = 0;
    bool popped_too_often = false;
    bool final_depth_writes = true;
    std::vector<unsigned> final_enabled;
    Settings final_settings;
};

/// Follows calls on the matrix stack, in double, with matrices written out from the specification.
Replay replay(const std::vector<Call>& calls);

} // namespace recording_gl
