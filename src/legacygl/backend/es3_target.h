#pragma once

#include "legacygl/backend/es3_functions.h"

#include <legacygl/legacygl.h>

namespace legacygl {

/// Where an ES backend draws: the framebuffer it was given, or one of its own that keeps its contents.
class Es3Target
{
public:
    /// Takes the framebuffer bound now as the given one. width and height are at least 1.
    Es3Target(const Es3Functions& gl, LegacyGLTarget kind, int width, int height);

    /// Makes the target's objects again; their contents are cleared. Call after a lost context.
    void restore();
    /// Binds the target for drawing and reading.
    void bind();
    /// Changes the size; an own target keeps what fits, anchored at the bottom left.
    void resize(int width, int height);
    /// Copies an own target into the given framebuffer and binds the target again.
    void present();
    /// Frees the objects. The context is current.
    void destroy();
    void forget();

private:
    void make_framebuffer();
    GLuint make_copy_program();

    const Es3Functions& gl_;
    LegacyGLTarget kind_;
    int width_;
    int height_;
    GLuint given_ = 0;
    GLuint framebuffer_ = 0;
    GLuint color_ = 0; ///< A texture, so that present() can draw it where a blit is not allowed.
    GLuint depth_stencil_ = 0;
    GLuint copy_program_ = 0;
    GLuint copy_vertex_array_ = 0;
};

} // namespace legacygl
