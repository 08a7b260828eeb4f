#pragma once

#include "legacygl/backend/es3_fullscreen_pass.h"
#include "legacygl/backend/es3_functions.h"

#include <legacygl/legacygl.h>

#include <array>

namespace legacygl {

/// Where an ES backend draws: the framebuffer it was given, or one of its own that keeps its contents.
class Es3Target
{
public:
    /// Takes the framebuffer bound now as the given one. width and height are at least 1.
    Es3Target(const Es3Functions& gl, Es3FullscreenPass& fullscreen_pass, LegacyGLTarget kind, int width,
              int height);

    /// Makes the target's objects again; their contents are cleared. Call after a lost context.
    void restore();
    /// Binds what is drawn into: the front colours, the back ones, or both (OpenGL 1.5, 4.2.1). Where there
    /// is but one buffer it is that.
    void draw_into(bool front, bool back);
    /// Binds what is read from.
    void read_from(bool front);
    /// Changes the size; an own target keeps what fits, anchored at the bottom left.
    void resize(int width, int height);
    /// Copies an own target's back into its front and shows that. The caller binds again.
    void present();
    /// Copies an own target's front into the given framebuffer. The caller binds again.
    void show_front();
    /// Frees the objects. The context is current.
    void destroy();
    void forget();

private:
    /// Textures, so that the front can be drawn where a blit is not allowed. Where there is one buffer it is
    /// the back here, and the others are 0.
    struct Buffers
    {
        std::array<GLuint, 2> colors{}; ///< back, front
        GLuint depth_stencil = 0;
        std::array<GLuint, 3> framebuffers{}; ///< back, front, both
    };
    enum Which : int
    {
        back,
        front,
        both
    };

    bool own() const { return kind_ != LEGACYGL_TARGET_WINDOW; }
    bool doubled() const { return kind_ == LEGACYGL_TARGET_OWN; }
    Buffers make_buffers();
    GLuint make_color();
    GLuint make_framebuffer(const Buffers& buffers, Which which);
    void delete_buffers(Buffers& buffers);
    void copy(const Buffers& from, const Buffers& to, Which which, int width, int height, GLbitfield what);

    const Es3Functions& gl_;
    Es3FullscreenPass& fullscreen_pass_;
    LegacyGLTarget kind_;
    int width_;
    int height_;
    GLuint given_ = 0;
    Buffers buffers_;
};

} // namespace legacygl
