#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/context/capture.h"
#include "legacygl/draw/renderer.h"
#include "legacygl/list/display_list.h"
#include "legacygl/state/attribute_stack.h"
#include "legacygl/state/state.h"
#include "legacygl/vertex/assembler.h"
#include "legacygl/vertex/client_arrays.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace legacygl {

/// How deep lists may call lists.
constexpr int MAX_LIST_NESTING_DEPTH = 64;

/// One OpenGL: its state, its lists, and what draws for it.
struct Context
{
    Context(std::unique_ptr<Backend> made, int width, int height, bool double_buffered = true);

    std::unique_ptr<Backend> backend; ///< First, so that lists and textures can free their objects.
    State state;
    ClientArrays client_arrays;
    std::map<GLuint, std::shared_ptr<BufferObject>> buffers; ///< A name without a buffer is only reserved.
    GLenum error = GL_NO_ERROR;
    VertexAssembler immediate{state.current, VertexAssembler::Use::immediate};
    Renderer renderer;
    ListStore lists;
    std::optional<ListCompiler> compiler;                 ///< Between glNewList and glEndList.
    std::vector<SavedAttributes> attributes;              ///< Of glPushAttrib.
    std::vector<SavedClientAttributes> client_attributes; ///< Of glPushClientAttrib.
    int list_depth = 0;                                   ///< How many lists are being called.
    Capture capture;
    const bool double_buffered;

    /// Notes an error; the first one stays until glGetError (OpenGL 1.5, 2.5).
    ///
    /// An unchecked build takes programs to be free of errors, as a context of GL_KHR_no_error does: the
    /// compiler drops whatever only leads here.
    void set_error([[maybe_unused]] GLenum code)
    {
#ifdef LEGACYGL_UNCHECKED
        __builtin_unreachable();
#endif
        if (error == GL_NO_ERROR) {
            error = code;
        }
    }
    /// Notes GL_INVALID_OPERATION for what legacygl cannot do: no fault of the program's, so also unchecked.
    void refuse_unsupported()
    {
        if (error == GL_NO_ERROR) {
            error = GL_INVALID_OPERATION;
        }
    }
    template <class... Args> void note(const char* name, const Args&... args)
    {
        capture.note(name, list_depth, state.transform.modelview.top().values(), args...);
    }

    void begin(GLenum mode);
    void end();
    /// Draws the vertices that wait; every change of state does so first.
    void flush_vertices()
    {
        if (!immediate.batch().primitives.empty()) {
            draw_vertices();
        }
    }
    /// Runs the list of that name; unknown names and too deep a nesting do nothing (OpenGL 1.5, 5.4).
    void call_list(GLuint name);
    /// Returns the buffer of that name, or null.
    std::shared_ptr<BufferObject> find_buffer(GLuint name) const
    {
        const auto found = buffers.find(name);
        return found == buffers.end() ? nullptr : found->second;
    }
    MatrixStack& current_matrix_stack();
    /// Writes the colour into the material properties that follow it.
    void store_followed_color();

private:
    /// Draws what waits with the colour and texture coordinates it has, if some of the attributes in set
    /// (bits of Attribute) are such: from here on each primitive has its own, which fragments then
    /// interpolate, see takes_one_color() and TextureKey::constant.
    void begin_varying(std::uint32_t set);
    void draw_vertices();
};

/// The context that gl* calls go to; null when there is none.
extern Context* current_context;

} // namespace legacygl
