#pragma once

#include "legacygl/context/context.h"

#include <utility>

namespace legacygl {

/// Whether a command may stand between glBegin and glEnd (OpenGL 1.5, 2.6.3).
enum class Where : bool
{
    outside,
    anywhere
};

/// Executes a command now: notes it for a capture, refuses it where it may not be, and draws what waits.
template <Where where, class Operation, class... Args>
void execute(Context& gl, const char* name, Operation operation, const Args&... args)
{
    if (gl.capture.active()) {
        gl.note(name, args...);
    }
    if constexpr (where == Where::outside) {
        if (gl.immediate.inside()) {
            return gl.set_error(GL_INVALID_OPERATION);
        }
        gl.flush_vertices();
    }
    operation(gl, args...);
}

template <class T> T kept(ListCompiler&, const T& value)
{
    return value;
}

inline Blob kept(ListCompiler& compiler, const Blob& blob)
{
    return compiler.keep(blob);
}

/// Sends a command where it belongs: executes it, compiles it into the list being made, or both.
///
/// An entry point says once what it does, as a captureless operation over its arguments; nothing else
/// decides between now and later. What a Blob points to is copied when it is compiled.
template <Where where = Where::outside, class Operation, class... Args>
void dispatch(const char* name, Operation operation, Args... args)
{
    Context* gl = current_context;
    if (!gl) {
        return;
    }
    if (gl->compiler) {
        const bool executes = gl->compiler->executes();
        if (gl->capture.active() && !executes) {
            gl->note(name, args...);
        }
        [&](auto... held) {
            gl->compiler->append(
                [=](Context& context) { execute<where>(context, name, operation, held...); });
        }(kept(*gl->compiler, args)...);
        if (!executes) {
            return;
        }
    }
    execute<where>(*gl, name, operation, args...);
}

/// Executes a command that is never compiled (OpenGL 1.5, 5.4), also while a list is being made.
template <Where where = Where::outside, class Operation, class... Args>
void dispatch_now(const char* name, Operation operation, Args... args)
{
    if (Context* gl = current_context) {
        execute<where>(*gl, name, operation, args...);
    }
}

/// What dispatch_vertex does where calls are captured or a list is compiled. By itself, so that the rest
/// needs no stack.
template <class Operation, class... Args>
[[gnu::noinline]] void dispatch_vertex_watched(Context& gl, const char* name, Operation operation,
                                               Args... args)
{
    if (gl.capture.active()) {
        gl.note(name, args...);
    }
    if (gl.compiler) {
        operation(gl.compiler->vertices(), args...);
        if (!gl.compiler->executes()) {
            return;
        }
    }
    operation(gl.immediate, args...);
}

/// Sends glVertex, glNormal … to the vertices being assembled: now, in the list, or both.
template <class Operation, class... Args>
void dispatch_vertex(const char* name, Operation operation, Args... args)
{
    Context* gl = current_context;
    if (!gl) {
        return;
    }
    // One branch for what is rare: these are the calls that programs make most.
    if (static_cast<int>(gl->capture.active()) | static_cast<int>(gl->compiler.has_value())) [[unlikely]] {
        return dispatch_vertex_watched(*gl, name, operation, args...);
    }
    operation(gl->immediate, args...);
}

} // namespace legacygl
