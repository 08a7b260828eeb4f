#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string>
#include <string_view>
#include <vector>

/// A stand-in for OpenGL that draws nothing and writes down what it is asked: linked instead of a library,
/// it defines the gl* and glu* functions that scene/ calls, and no others.
namespace recording_gl {

struct Call
{
    std::string name;
    std::vector<double> arguments; ///< numbers; of a pointer, what it points to
    unsigned compiled_into;        ///< the list that was being compiled; 0: none
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

/// Makes the next glGetError return this.
void set_error(unsigned error);

/// What the program sees when a list is called: the modelview matrix and what is enabled.
struct ListCall
{
    unsigned list;
    glm::dmat4 modelview;
    std::vector<unsigned> enabled; ///< GLenum of what is on, sorted
    bool depth_writes;
    std::size_t stack_depth; ///< pushes that are not popped

    bool is_enabled(unsigned capability) const;
};

/// What following a frame's calls gives.
struct Replay
{
    std::vector<ListCall> list_calls;
    std::vector<glm::dmat4> light_positions_set_under; ///< the modelview at each GL_POSITION of a light
    std::size_t final_stack_depth = 0;
    bool popped_too_often = false;
    bool final_depth_writes = true;
};

/// Follows calls on the matrix stack, in double, with matrices written out from the specification.
Replay replay(const std::vector<Call>& calls);

} // namespace recording_gl
