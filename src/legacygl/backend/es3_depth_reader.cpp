#include "legacygl/backend/es3_depth_reader.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace legacygl {
namespace {

/// The depth's 24 bits, the highest eight in red. What is sampled is steps / (2^24 - 1) and some drivers
/// round it up on the way: excess is 1, or 2 for those (see excess_of_depths).
constexpr const char* DEPTH_FRAGMENT = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D depths;
uniform int excess;
out vec4 color;
void main()
{
    float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    float steps = depth >= 1.0 ? 16777215.0 : round(depth * 16777216.0 - depth * float(excess));
    float high = floor(steps / 65536.0);
    float middle = floor((steps - high * 65536.0) / 256.0);
    color = vec4(high, middle, steps - high * 65536.0 - middle * 256.0, 255.0) / 255.0;
}
)";

constexpr const char* WHITE_FRAGMENT = R"(#version 300 es
precision highp float;
precision highp int;
out vec4 color;
void main()
{
    color = vec4(1.0);
}
)";

} // namespace

/// A copy of a target's depth and stencil, and colours of the same size to draw into. Bound for both while it
/// lives.
struct Es3DepthReader::Copy
{
    Copy(const Es3Functions& functions, const TargetRectangle& from)
        : gl(functions), width(from.target_width), height(from.target_height)
    {
        gl.ActiveTexture(GL_TEXTURE0);
        gl.GenTextures(2, textures);
        make_texture(textures[0], GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
        make_texture(textures[1], GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
        gl.GenFramebuffers(1, &framebuffer);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
        attach_depths(textures[1]);
        gl.Disable(GL_SCISSOR_TEST); // It would cut copies too.
        gl.DepthMask(GL_TRUE);
        gl.StencilMask(~0u);
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.Viewport(0, 0, width, height);
        gl.Disable(GL_DEPTH_TEST);
        gl.Disable(GL_CULL_FACE);
    }
    /// Copies depths and stencil values. Returns false when ES refuses to.
    bool take() const
    {
        while (gl.GetError() != GL_NO_ERROR) {
        }
        gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height,
                           GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
        return gl.GetError() == GL_NO_ERROR;
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;
    ~Copy()
    {
        gl.DeleteFramebuffers(1, &framebuffer);
        gl.DeleteTextures(2, textures);
    }

    void make_texture(GLuint name, GLenum internal_format, GLenum format, GLenum type) const
    {
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, format, type,
                      nullptr);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    void attach_depths(GLuint texture) const
    {
        gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    }
    /// Reads what was drawn.
    std::vector<std::uint8_t> read(const TargetRectangle& from) const
    {
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        std::vector<std::uint8_t> rgba(static_cast<std::size_t>(from.width) * from.height * 4);
        gl.ReadPixels(from.x, from.y, from.width, from.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    }

    const Es3Functions& gl;
    GLuint textures[2] = {}; ///< colours; depth and stencil
    GLuint framebuffer = 0;
    GLsizei width, height;
};

/// Draws the copy's depths into its colours and reads them.
std::vector<std::uint32_t> Es3DepthReader::decode(const Copy& copy, int excess, const TargetRectangle& from)
{
    copy.attach_depths(0); // They may not be read and attached.
    gl_.BindTexture(GL_TEXTURE_2D, copy.textures[1]);
    gl_.Uniform1i(gl_.GetUniformLocation(fullscreen_pass_.use(DEPTH_FRAGMENT), "excess"), excess);
    fullscreen_pass_.draw();
    copy.attach_depths(copy.textures[1]);
    const std::vector<std::uint8_t> rgba = copy.read(from);
    std::vector<std::uint32_t> depths(rgba.size() / 4);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        depths[i] = static_cast<std::uint32_t>(rgba[4 * i] << 16 | rgba[4 * i + 1] << 8 | rgba[4 * i + 2]);
    }
    return depths;
}

/// Finds how the driver makes a number of 24 bits, from a depth that is one of them and that shows it.
int Es3DepthReader::excess_of_depths(const Copy& copy, const TargetRectangle& from)
{
    constexpr std::uint32_t STEPS = 13421772; // 0.8 * (2^24 - 1)
    gl_.ClearDepthf(0.8f);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    const TargetRectangle one = {from.target_width, from.target_height, 0, 0, 1, 1};
    return decode(copy, 1, one).front() == STEPS ? 1 : 2;
}

bool Es3DepthReader::read_depths(const TargetRectangle& from, std::span<std::uint32_t> depths)
{
    const Copy copy(gl_, from);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_STENCIL_TEST);
    GLint source = 0;
    gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &source);
    const int excess = excess_of_depths(copy, from);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(source));
    if (!copy.take()) {
        return false;
    }
    const std::vector<std::uint32_t> decoded = decode(copy, excess, from);
    std::copy(decoded.begin(), decoded.end(), depths.begin());
    return true;
}

bool Es3DepthReader::read_stencils(const TargetRectangle& from, std::span<std::uint8_t> values)
{
    const Copy copy(gl_, from);
    if (!copy.take()) {
        return false;
    }
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    fullscreen_pass_.use(WHITE_FRAGMENT);
    gl_.Enable(GL_STENCIL_TEST);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_CONSTANT_COLOR, GL_ONE, GL_ONE, GL_ONE);
    gl_.BlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
    for (int bit = 1; bit < 256; bit *= 2) { // Each bit that is set adds itself.
        gl_.StencilFunc(GL_EQUAL, bit, static_cast<GLuint>(bit));
        gl_.BlendColor(static_cast<float>(bit) / 255.0f, 0, 0, 0);
        fullscreen_pass_.draw();
    }
    const std::vector<std::uint8_t> rgba = copy.read(from);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = rgba[4 * i];
    }
    return true;
}

} // namespace legacygl
