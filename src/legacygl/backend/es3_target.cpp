#include "legacygl/backend/es3_target.h"

#include <algorithm>

namespace legacygl {
namespace {

constexpr const char* COPY_FRAGMENT = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D picture;
out vec4 color;
void main()
{
    color = vec4(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 1.0);
}
)";

} // namespace

Es3Target::Es3Target(const Es3Functions& gl, Es3FullscreenPass& fullscreen_pass, LegacyGLTarget kind,
                     int width, int height)
    : gl_(gl), fullscreen_pass_(fullscreen_pass), kind_(kind), width_(width), height_(height)
{
    GLint given = 0;
    gl_.GetIntegerv(GL_FRAMEBUFFER_BINDING, &given);
    given_ = static_cast<GLuint>(given);
    restore();
}

void Es3Target::restore()
{
    if (own()) {
        buffers_ = make_buffers();
    }
}

GLuint Es3Target::make_color()
{
    GLuint name = 0;
    gl_.GenTextures(1, &name);
    gl_.BindTexture(GL_TEXTURE_2D, name);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

GLuint Es3Target::make_framebuffer(const Buffers& buffers, Which which)
{
    GLuint name = 0;
    gl_.GenFramebuffers(1, &name);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name);
    const auto attach = [this](GLenum where, GLuint color) {
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, color, 0);
    };
    attach(GL_COLOR_ATTACHMENT0, buffers.colors[which == front ? front : back]);
    if (which == both) {
        attach(GL_COLOR_ATTACHMENT1, buffers.colors[front]);
        constexpr GLenum DRAW_BUFFERS[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        gl_.DrawBuffers(2, DRAW_BUFFERS);
    }
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                buffers.depth_stencil);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthMask(GL_TRUE);
    gl_.StencilMask(~0u);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.ClearDepthf(1);
    gl_.ClearStencil(0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    return name;
}

Es3Target::Buffers Es3Target::make_buffers()
{
    Buffers buffers;
    gl_.GenRenderbuffers(1, &buffers.depth_stencil);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffers.depth_stencil);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width_, height_);
    buffers.colors[back] = make_color();
    if (doubled()) {
        buffers.colors[front] = make_color();
    }
    buffers.framebuffers[back] = make_framebuffer(buffers, back);
    if (doubled()) {
        buffers.framebuffers[front] = make_framebuffer(buffers, front);
        buffers.framebuffers[both] = make_framebuffer(buffers, both);
    }
    return buffers;
}

void Es3Target::delete_buffers(Buffers& buffers)
{
    gl_.DeleteFramebuffers(3, buffers.framebuffers.data());
    gl_.DeleteTextures(2, buffers.colors.data());
    gl_.DeleteRenderbuffers(1, &buffers.depth_stencil);
    buffers = {};
}

void Es3Target::draw_into(bool to_front, bool to_back)
{
    const Which which = !doubled() || !to_front ? back : to_back ? both : front;
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, own() ? buffers_.framebuffers[which] : given_);
}

void Es3Target::read_from(bool from_front)
{
    const Which which = doubled() && from_front ? front : back;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, own() ? buffers_.framebuffers[which] : given_);
}

void Es3Target::copy(const Buffers& from, const Buffers& to, Which which, int width, int height,
                     GLbitfield what)
{
    gl_.Disable(GL_SCISSOR_TEST); // It would cut the copy too.
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffers[&from == &to ? back : which]);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffers[which]);
    gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
}

void Es3Target::resize(int width, int height)
{
    const int kept_width = std::min(width, width_), kept_height = std::min(height, height_);
    width_ = width;
    height_ = height;
    if (!own()) {
        return;
    }
    Buffers old = buffers_;
    buffers_ = make_buffers();
    copy(old, buffers_, back, kept_width, kept_height,
         GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (doubled()) {
        copy(old, buffers_, front, kept_width, kept_height, GL_COLOR_BUFFER_BIT);
    }
    delete_buffers(old);
}

void Es3Target::present()
{
    if (doubled()) {
        copy(buffers_, buffers_, front, width_, height_, GL_COLOR_BUFFER_BIT);
    }
    show_front();
}

void Es3Target::show_front()
{
    if (!own()) {
        return;
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, given_);
    // Without a window (EGL's surfaceless platform) there is nothing to copy into.
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return;
    }
    // Drawn, not blitted: ES does not blit into the antialiased framebuffer a window may have.
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_STENCIL_TEST);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.Viewport(0, 0, width_, height_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, buffers_.colors[doubled() ? front : back]);
    fullscreen_pass_.use(COPY_FRAGMENT);
    fullscreen_pass_.draw();
}

void Es3Target::destroy()
{
    delete_buffers(buffers_);
}

void Es3Target::forget()
{
    buffers_ = {};
}

} // namespace legacygl
