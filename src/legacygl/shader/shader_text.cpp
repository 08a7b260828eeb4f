#include "legacygl/shader/shader_text.h"

#include "legacygl/shader/shader_lighting_text.h"
#include "legacygl/shader/shader_texture_text.h"
#include "legacygl/shader/shader_words.h"

#include <string>

namespace legacygl {
namespace {

/// The sampler of the target's copy, behind those of the texture units.
std::string target_copy_name()
{
    return "texture_" + std::to_string(TARGET_COPY_SAMPLER);
}

/// The varyings between the shaders, in the direction given ("out" or "in").
std::string varyings(const ShaderKey& key, const char* direction)
{
    const std::string prefix = std::string(key.flat ? "flat " : "") + direction + " vec4 ";
    std::string text = prefix + "front_color;\n";
    const bool two_side = key.lighting && key.two_side;
    if (two_side) {
        text += prefix + "back_color;\n";
    }
    if (key.secondary()) {
        text += prefix + "front_secondary;\n";
        if (two_side) {
            text += prefix + "back_secondary;\n";
        }
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].format != BaseFormat::none) {
            text += std::string(key.textures[unit].constant ? "flat " : "") + direction +
                    " vec4 texture_position_" + std::to_string(unit) + ";\n";
        }
    }
    if (key.fog_mode) {
        text += std::string(direction) + " float fog_distance;\n";
    }
    if (key.coverage != Coverage::whole) {
        text += std::string(direction) + " vec4 coverage;\n";
    }
    return text;
}

std::string uniforms(const char* name, int size)
{
    return std::string("uniform vec4 ") + name + "[" + std::to_string(size) + "];\n";
}

/// Puts a point's centre where OpenGL 1.5, 3.3.1, rounds it to: ES rasterises sprites, whose centres are not
/// rounded. size and viewport are names of a float and a vec4.
std::string snapped_point_text(const std::string& size, const std::string& viewport)
{
    return "    vec2 window = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * " + viewport +
           ".zw;\n"
           "    window = floor(window * 256.0 + 0.5) / 256.0;\n"
           "    window = mod(" +
           size +
           ", 2.0) == 1.0 ? floor(window) + 0.5 : floor(window + 0.5);\n"
           "    gl_Position.xy = (window / " +
           viewport + ".zw * 2.0 - 1.0) * gl_Position.w;\n";
}

/// Points whose centre lies outside of the clip volume are dropped; those that come shaded are not any more.
std::string point_text(const ShaderKey& key, const TransformLayout& layout)
{
    const std::string viewport = of_transform(layout.point);
    const std::string size = key.shaded ? "extra.x" : of_transform(layout.point + 1) + ".x";
    const std::string set_size = "    gl_PointSize = " + size + ";\n";
    if (key.shaded) {
        return set_size + snapped_point_text(size, viewport);
    }
    return set_size +
           "    vec3 limit = abs(gl_Position.xyz);\n"
           "    if (max(limit.x, max(limit.y, limit.z)) > gl_Position.w) {\n"
           "        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);\n"
           "    } else {\n" +
           snapped_point_text(size, viewport) + "    }\n";
}

/// Sphere mapping (OpenGL 1.5, 2.11.4): the direction of the reflection, seen in a sphere.
constexpr const char* SPHERE_TEXT =
    "    vec3 to_vertex = eye.xyz * inversesqrt(dot(eye.xyz, eye.xyz));\n"
    "    float n_twice = dot(n, to_vertex);\n"
    "    n_twice = n_twice + n_twice;\n"
    "    vec3 reflection = -n_twice * n + to_vertex;\n"
    "    vec3 half_way = reflection + vec3(0.0, 0.0, 1.0);\n"
    "    vec4 sphere = vec4(reflection * (inversesqrt(dot(half_way, half_way)) * 0.5) + 0.5, 1.0);\n";

std::string transform_columns_times(int first, const std::string& v)
{
    return columns_times([first](int i) { return of_transform(first + i); }, v);
}

std::string clamped(const std::string& name)
{
    return "    " + name + " = clamp(" + name + ", 0.0, 1.0);\n";
}

std::string vertex_text(const ShaderKey& key)
{
    const TransformLayout layout(key);
    std::string text = "#version 300 es\n"
                       "precision highp float;\n"
                       "invariant gl_Position;\n"
                       "layout(location = 0) in vec4 position;\n"
                       "layout(location = 1) in " +
                       std::string(key.shaded ? "vec4 extra" : "vec3 normal") +
                       ";\n"
                       "layout(location = 2) in vec4 color;\n"
                       "layout(location = 3) in vec4 secondary_color;\n"
                       "layout(location = 4) in float fog_coordinate;\n"
                       "layout(location = 5) in vec4 texture_coordinate_0;\n"
                       "layout(location = 6) in vec4 texture_coordinate_1;\n";
    text += "layout(location = " + std::to_string(TRANSFORM_SLOT_LOCATION) + ") in float transform_slot;\n";
    text += uniforms("transform", layout.size * layout.slots());
    if (key.lighting) {
        text += uniforms("lighting", lighting_layout::size(key.light_count));
    }
    if (key.textured()) {
        text += uniforms("texturing", texturing_layout::SIZE);
    }
    text += varyings(key, "out");
    text += "void main()\n{\n";
    text += "    int slot = (int(transform_slot) & " + std::to_string(layout.slots() - 1) + ") * " +
            std::to_string(layout.size) + ";\n";
    text += "    gl_Position = " +
            (key.shaded ? "position" : transform_columns_times(layout.projection_modelview, "position")) +
            ";\n";
    if (key.needs_eye_position()) {
        text += "    vec4 eye = " + transform_columns_times(layout.modelview, "position") + ";\n";
    }
    if (key.needs_normal()) {
        text += normal_text(key);
    }
    text += key.lighting ? lighting_text(key) : "    front_color = color;\n";
    if (key.color_sum) {
        text += "    front_secondary = secondary_color;\n";
    }
    text += clamped("front_color");
    const bool two_side = key.lighting && key.two_side;
    if (two_side) {
        text += clamped("back_color");
    }
    if (key.secondary()) {
        text += clamped("front_secondary");
        if (two_side) {
            text += clamped("back_secondary");
        }
    }
    if (key.generates(GL_SPHERE_MAP)) {
        text += SPHERE_TEXT;
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].format != BaseFormat::none) {
            text += texture_coordinate_text(key, unit);
        }
    }
    if (key.fog_mode) {
        text +=
            key.fog_coordinate ? "    fog_distance = fog_coordinate;\n" : "    fog_distance = abs(eye.z);\n";
    }
    if (key.coverage != Coverage::whole) {
        text += "    coverage = extra;\n";
    }
    if (key.points) {
        text += point_text(key, layout);
    }
    return text + "}\n";
}

/// Fog (OpenGL 1.5, 3.10), with the factors that FOG_FACTORS holds.
std::string fog_text(const ShaderKey& key)
{
    using namespace fragments_layout;
    const std::string factors = at("fragments", FOG_FACTORS);
    std::string text;
    if (key.fog_mode == GL_LINEAR) {
        text = "    float f = fog_distance * " + factors + ".x + " + factors + ".y;\n";
    } else if (key.fog_mode == GL_EXP) {
        text = "    float f = exp2(-(fog_distance * " + factors + ".z));\n";
    } else {
        text = "    float f = fog_distance * " + factors + ".w;\n    f = exp2(-(f * f));\n";
    }
    return text + "    f = clamp(f, 0.0, 1.0);\n    c.rgb = " + at("fragments", FOG_COLOR) +
           ".rgb * (1.0 - f) + c.rgb * f;\n";
}

/// The alpha test (OpenGL 1.5, 4.1.4), on the alpha that a colour buffer of eight bits would hold.
std::string alpha_text(GLenum func)
{
    if (func == GL_NEVER) {
        return "    discard;\n";
    }
    // GL_NEVER … GL_ALWAYS are in a row; each is the condition to go on.
    constexpr const char* conditions[] = {"<", "==", "<=", ">", "!=", ">="};
    return "    if (!(round(clamp(c.a, 0.0, 1.0) * 255.0) " + std::string(conditions[func - GL_LESS]) + " " +
           at("fragments", fragments_layout::ALPHA_REFERENCE) + ".x))\n        discard;\n";
}

/// Polygon stipple (OpenGL 1.5, 3.5.2).
std::string polygon_stipple_text()
{
    return "    ivec2 bit = ivec2(gl_FragCoord.xy) & 31;\n"
           "    vec4 rows = fragments[" +
           std::to_string(fragments_layout::STIPPLE) +
           " + (bit.y >> 1)];\n"
           "    vec2 row = (bit.y & 1) == 0 ? rows.xy : rows.zw;\n"
           "    int part = int(bit.x < 16 ? row.x : row.y);\n"
           "    if (((part >> (15 - (bit.x & 15))) & 1) == 0)\n        discard;\n";
}

/// Makes the edge of a smooth line or point transparent, as the corners of add_smooth_line() and
/// add_smooth_point() want it. A line covers no more of a pixel than it is long.
std::string coverage_text(Coverage coverage)
{
    if (coverage == Coverage::line) {
        return "    c.a = c.a * (clamp(coverage.y - abs(coverage.x), 0.0, 1.0) *\n"
               "                 min(clamp(coverage.w - abs(coverage.z), 0.0, 1.0), coverage.w * 2.0 - "
               "1.0));\n";
    }
    return "    float squared = coverage.x * coverage.x + coverage.y * coverage.y;\n"
           "    if (coverage.w < squared)\n        discard;\n"
           "    c.a = c.a * (coverage.z >= squared ? (1.0 / (coverage.w - coverage.z)) * (coverage.w - "
           "squared)\n"
           "                                       : coverage.w);\n";
}

/// A logic op (OpenGL 1.5, 4.1.10) of the bits that a colour buffer of eight bits would hold.
std::string logic_op_text(GLenum op)
{
    // GL_CLEAR … GL_SET are in a row; s is the fragment, d what is there.
    constexpr const char* operations[] = {"ivec4(0)", "s & d",  "s & ~d",   "s",         "~s & d", "d",
                                          "s ^ d",    "s | d",  "~(s | d)", "~(s ^ d)",  "~d",     "s | ~d",
                                          "~s",       "~s | d", "~(s & d)", "ivec4(255)"};
    return "    ivec4 s = ivec4(round(clamp(c, 0.0, 1.0) * 255.0));\n"
           "    ivec4 d = ivec4(round(texelFetch(" +
           target_copy_name() + ", ivec2(gl_FragCoord.xy) - ivec2(" +
           at("fragments", fragments_layout::TARGET_COPY_ORIGIN) +
           ".xy), 0) * 255.0));\n"
           "    c = vec4((" +
           std::string(operations[op - GL_CLEAR]) + ") & 255) / 255.0;\n";
}

/// Multiplies the colour by its weight as a colour buffer of eight bits would: the weight comes in 255ths.
std::string blend_weight_text()
{
    return "    c.rgb = round(round(clamp(c.rgb, 0.0, 1.0) * 255.0) * " +
           at("fragments", fragments_layout::BLEND_WEIGHT) + ".rgb / 255.0) / 255.0;\n";
}

std::string fragment_text(const ShaderKey& key)
{
    const bool two_side = key.lighting && key.two_side;
    std::string text = "#version 300 es\n"
                       "precision highp float;\n"
                       "precision highp int;\n" // Of 16 bits, by default, a stipple's half row is negative.
                       "precision highp sampler2D;\n";
    text += varyings(key, "in");
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].format != BaseFormat::none) {
            text += "uniform sampler2D texture_" + std::to_string(unit) + ";\n";
        }
    }
    if (key.logic_op != GL_COPY) {
        text += "uniform sampler2D " + target_copy_name() + ";\n";
    }
    if (key.textured()) {
        text += uniforms("texturing", texturing_layout::SIZE);
    }
    text += uniforms("fragments", fragments_layout::size(key.polygon_stipple));
    text += key.both_buffers ? "layout(location = 0) out vec4 fragment_color;\n"
                               "layout(location = 1) out vec4 front_fragment_color;\n"
                             : "out vec4 fragment_color;\n";
    text += "void main()\n{\n";
    if (key.polygon_stipple) {
        text += polygon_stipple_text();
    }
    text += two_side ? "    vec4 c = gl_FrontFacing ? front_color : back_color;\n"
                     : "    vec4 c = front_color;\n";
    if (key.textured()) {
        text += texture_environment_text(key);
    }
    if (key.secondary()) {
        text += two_side ? "    c.rgb += (gl_FrontFacing ? front_secondary : back_secondary).rgb;\n"
                         : "    c.rgb += front_secondary.rgb;\n";
    }
    if (key.fog_mode) {
        text += fog_text(key);
    }
    if (key.coverage != Coverage::whole) {
        text += coverage_text(key.coverage);
    }
    if (key.alpha_func != GL_ALWAYS) {
        text += alpha_text(key.alpha_func);
    }
    if (key.blend_weight) {
        text += blend_weight_text();
    }
    if (key.logic_op != GL_COPY) {
        text += logic_op_text(key.logic_op);
    }
    if (key.both_buffers) {
        text += "    front_fragment_color = c;\n";
    }
    return text + "    fragment_color = c;\n}\n";
}

} // namespace

ProgramText make_program_text(const ShaderKey& key)
{
    return {vertex_text(key), fragment_text(key), TransformLayout(key).slots(), attributes_read(key)};
}

} // namespace legacygl
