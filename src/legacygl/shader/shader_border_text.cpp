#include "legacygl/shader/shader_border_text.h"

#include "legacygl/shader/shader_words.h"

namespace legacygl {
namespace {

bool is_linear(GLenum filter)
{
    return filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST || filter == GL_LINEAR_MIPMAP_LINEAR;
}

bool is_mipmapped(GLenum filter)
{
    return filter != GL_NEAREST && filter != GL_LINEAR;
}

/// Returns the expression of how much of a texel is inside the texture along one coordinate.
/// u: the coordinate in texels, size: the texture's, as expressions.
std::string inside(GLenum wrap, bool linear, const std::string& u, const std::string& size)
{
    if (wrap == 0 || (wrap == GL_CLAMP && !linear)) {
        return "";
    }
    if (!linear) {
        return "(" + u + " >= 0.0 && " + u + " < " + size + " ? 1.0 : 0.0)";
    }
    const std::string at = wrap == GL_CLAMP ? "clamp(" + u + ", 0.0, " + size + ")" : u;
    return "(1.0 - clamp(0.5 - " + at + ", 0.0, 1.0)) * (1.0 - clamp(" + at + " - " + size +
           " + 0.5, 0.0, 1.0))";
}

/// Returns the expression of the weight inside, along both coordinates, for one kind of filter.
std::string weight(const TextureKey& texture, bool linear)
{
    const std::string s = inside(texture.border_wrap[0], linear, "at.x", "size.x");
    const std::string t = inside(texture.border_wrap[1], linear, "at.y", "size.y");
    if (s.empty() && t.empty()) {
        return "1.0";
    }
    return s.empty() ? t : t.empty() ? s : s + " * " + t;
}

} // namespace

std::string border_text(const ShaderKey& key, int unit)
{
    const TextureKey& texture = key.textures[unit];
    if (!texture.has_border()) {
        return "";
    }
    const std::string number = std::to_string(unit), place = "texture_position_" + number;
    const std::string minified = weight(texture, is_linear(texture.minify)),
                      magnified = weight(texture, is_linear(texture.magnify));
    std::string text = "    {\n        vec2 size = vec2(textureSize(texture_" + number +
                       ", 0));\n        vec2 at = " + place + ".xy / " + place + ".w * size;\n";
    if (minified == magnified && !is_mipmapped(texture.minify)) {
        text += "        float weight = " + magnified + ";\n";
    } else {
        text +=
            "        float level = 0.5 * log2(max(dot(dFdx(at), dFdx(at)), dot(dFdy(at), dFdy(at))))" +
            (texture.lod_bias
                 ? " + " + at("texturing", unit * texturing_layout::UNIT_SIZE + texturing_layout::LOD_BIAS) +
                       ".x"
                 : std::string()) +
            ";\n        float weight = " + magnified + ";\n        if (level > 0.0) {\n";
        if (is_mipmapped(texture.minify)) {
            text += "            vec2 smaller = max(vec2(1.0), floor(size * exp2(-floor(level + 0.5))));\n"
                    "            at *= smaller / size;\n"
                    "            size = smaller;\n";
        }
        text += "            weight = " + minified + ";\n        }\n";
    }
    return text + "        t" + number + " = mix(" +
           at("texturing", unit * texturing_layout::UNIT_SIZE + texturing_layout::BORDER_COLOR) + ", t" +
           number + ", weight);\n    }\n";
}

} // namespace legacygl
