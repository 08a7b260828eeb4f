#include "legacygl/backend/es3_target.h"

#include "legacygl/backend/es3_shader.h"

#include <algorithm>

namespace legacygl {
namespace {

constexpr const char* COPY_VERTEX = R"(#version 300 es
void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr const char* COPY_FRAGMENT = R"(#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
out vec4 color;
void main()
{
    color = vec4(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 1.0);
}
)";

} // namespace

Es3Target::Es3Target(const Es3Functions& gl, LegacyGLTarget kind, int width, int height)
    : gl_(gl), kind_(kind), width_(width), height_(height)
{
    GLint given = 0;
    gl_.GetIntegerv(GL_FRAMEBUFFER_BINDING, &given);
    given_ = static_cast<GLuint>(given);
    restore();
}

void Es3Target::restore()
{
    if (kind_ == LEGACYGL_TARGET_OWN)
        make_framebuffer();
    bind();
}

void Es3Target::make_framebuffer()
{
    gl_.GenTextures(1, &color_);
    gl_.BindTexture(GL_TEXTURE_2D, color_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.GenRenderbuffers(1, &depth_stencil_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_stencil_);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width_, height_);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_stencil_);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.ClearDepthf(1);
    gl_.ClearStencil(0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Es3Target::bind()
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, kind_ == LEGACYGL_TARGET_OWN ? framebuffer_ : given_);
}

void Es3Target::resize(int width, int height)
{
    const int kept_width = std::min(width, width_), kept_height = std::min(height, height_);
    width_ = width;
    height_ = height;
    if (kind_ != LEGACYGL_TARGET_OWN)
        return;
    const GLuint old_framebuffer = framebuffer_, old_color = color_, old_depth_stencil = depth_stencil_;
    make_framebuffer();
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, old_framebuffer);
    gl_.BlitFramebuffer(0, 0, kept_width, kept_height, 0, 0, kept_width, kept_height,
                        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    gl_.DeleteFramebuffers(1, &old_framebuffer);
    gl_.DeleteTextures(1, &old_color);
    gl_.DeleteRenderbuffers(1, &old_depth_stencil);
    bind();
}

void Es3Target::present()
{
    if (kind_ != LEGACYGL_TARGET_OWN)
        return;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, given_);
    // Without a window (EGL's surfaceless platform) there is nothing to copy into.
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) {
        if (copy_program_ == 0) {
            std::string message;
            copy_program_ = link_program(gl_, COPY_VERTEX, COPY_FRAGMENT, message);
            gl_.GenVertexArrays(1, &copy_vertex_array_);
        }
        // Drawn, not blitted: ES does not blit into the antialiased framebuffer a window may have.
        gl_.Disable(GL_BLEND);
        gl_.Disable(GL_DEPTH_TEST);
        gl_.Disable(GL_CULL_FACE);
        gl_.Disable(GL_SCISSOR_TEST);
        gl_.Disable(GL_STENCIL_TEST);
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl_.Viewport(0, 0, width_, height_);
        gl_.UseProgram(copy_program_);
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.BindTexture(GL_TEXTURE_2D, color_);
        gl_.BindVertexArray(copy_vertex_array_);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }
    bind();
}

void Es3Target::destroy()
{
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteTextures(1, &color_);
    gl_.DeleteRenderbuffers(1, &depth_stencil_);
    gl_.DeleteProgram(copy_program_);
    gl_.DeleteVertexArrays(1, &copy_vertex_array_);
    forget();
}

void Es3Target::forget()
{
    framebuffer_ = color_ = depth_stencil_ = copy_program_ = copy_vertex_array_ = 0;
}

} // namespace legacygl
