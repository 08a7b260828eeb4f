#include "legacygl/backend/es3_line_probe.h"

#include "legacygl/backend/es3_shader.h"

#include <array>
#include <cstdint>
#include <string>

namespace legacygl {
namespace {

constexpr int WIDTH = 8, HEIGHT = 3;

/// In the lowest row of pixels from far left to far right; in those above from the middle to the left edge
/// and beyond: to an end behind the eye, and to one at infinity.
constexpr const char* VERTEX = R"(#version 300 es
void main()
{
    const float row = 2.0 / 3.0;
    vec4 ends[6] = vec4[6](vec4(-1e6, -row, 0.0, 1.0), vec4(1e6, -row, 0.0, 1.0),
                           vec4(0.0, 0.0, 0.0, 1.0), vec4(-8.0, 0.0, 0.0, -1.0),
                           vec4(0.0, row, 0.0, 1.0), vec4(-1.0, 0.0, 0.0, 0.0));
    gl_Position = ends[gl_VertexID];
}
)";

constexpr const char* FRAGMENT = R"(#version 300 es
precision highp float;
out vec4 color;
void main()
{
    color = vec4(1.0);
}
)";

/// A small target of its own, which is bound while it lives.
class Target
{
public:
    explicit Target(const Es3Functions& gl) : gl_(gl)
    {
        gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
        gl_.GenRenderbuffers(1, &colors_);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, colors_);
        gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, WIDTH, HEIGHT);
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors_);
        gl_.Viewport(0, 0, WIDTH, HEIGHT);
        for (const GLenum capability : {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
            gl_.Disable(capability);
        }
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl_.LineWidth(1);
        gl_.ClearColor(0, 0, 0, 0);
        gl_.Clear(GL_COLOR_BUFFER_BIT);
    }
    ~Target()
    {
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(1, &colors_);
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

private:
    const Es3Functions& gl_;
    GLint draw_ = 0, read_ = 0;
    GLuint colors_ = 0, framebuffer_ = 0;
};

} // namespace

bool clips_lines(const Es3Functions& gl)
{
    const Target target(gl);
    std::string message;
    const GLuint program = link_program(gl, VERTEX, FRAGMENT, message);
    GLuint vertex_array = 0;
    gl.GenVertexArrays(1, &vertex_array);
    gl.BindVertexArray(vertex_array);
    gl.UseProgram(program);
    gl.DrawArrays(GL_LINES, 0, 6);
    std::array<std::uint8_t, static_cast<std::size_t>(WIDTH) * HEIGHT * 4> rgba{};
    gl.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    gl.DeleteVertexArrays(1, &vertex_array);
    gl.DeleteProgram(program);
    const auto drawn = [&](int x, int y) { return rgba[static_cast<std::size_t>(4 * (y * WIDTH + x))] != 0; };
    return drawn(1, 0) && drawn(6, 0) && drawn(1, 1) && !drawn(6, 1) && drawn(1, 2) && !drawn(6, 2);
}

} // namespace legacygl
