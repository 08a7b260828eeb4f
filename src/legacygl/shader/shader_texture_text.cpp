#include "legacygl/shader/shader_texture_text.h"

#include "legacygl/shader/shader_border_text.h"
#include "legacygl/shader/shader_words.h"

namespace legacygl {
namespace {

std::string texturing(int unit, int which)
{
    return at("texturing", unit * texturing_layout::UNIT_SIZE + which);
}

std::string texel(int unit)
{
    return "t" + std::to_string(unit);
}

/// The environments of OpenGL 1.5, tables 3.22 and 3.23: c is the fragment, t the texel.
std::string simple_environment(const TextureKey& key, int unit)
{
    const bool has_color = key.format != BaseFormat::alpha;
    const bool has_alpha = key.format != BaseFormat::rgb && key.format != BaseFormat::luminance;
    const std::string constant = texturing(unit, texturing_layout::ENVIRONMENT_COLOR);
    const std::string t = texel(unit);
    std::string color = "c.rgb", alpha = has_alpha ? "c.a * " + t + ".a" : "c.a";
    switch (key.environment) {
    case GL_REPLACE:
        color = has_color ? t + ".rgb" : color;
        alpha = has_alpha ? t + ".a" : alpha;
        break;
    case GL_DECAL:
        alpha = "c.a";
        if (key.format == BaseFormat::rgb) {
            color = t + ".rgb";
        } else if (key.format == BaseFormat::rgba) {
            color = "c.rgb * (1.0 - " + t + ".a) + " + t + ".rgb * " + t + ".a";
        }
        break;
    case GL_BLEND:
        if (has_color) {
            color = "c.rgb * (1.0 - " + t + ".rgb) + " + constant + ".rgb * " + t + ".rgb";
        }
        if (key.format == BaseFormat::intensity) {
            alpha = "c.a * (1.0 - " + t + ".a) + " + constant + ".a * " + t + ".a";
        }
        break;
    case GL_ADD:
        if (has_color) {
            color = "clamp(c.rgb + " + t + ".rgb, 0.0, 1.0)";
        }
        if (key.format == BaseFormat::intensity) {
            alpha = "clamp(c.a + " + t + ".a, 0.0, 1.0)";
        }
        break;
    default: // GL_MODULATE
        color = has_color ? "c.rgb * " + t + ".rgb" : color;
        break;
    }
    return "    c = vec4(" + color + ", " + alpha + ");\n";
}

/// The combine environment of OpenGL 1.5, table 3.24.
class CombineText
{
public:
    CombineText(const ShaderKey& key, int unit) : key_(key), unit_(unit) {}

    std::string text() const
    {
        const TextureKey& k = key_.textures[unit_];
        const std::string color = scaled(value(k.combine_rgb, true), k.combine_rgb);
        // The product of GL_DOT3_RGBA is the alpha, too, and that has its own scale.
        const std::string alpha = k.combine_rgb.function == GL_DOT3_RGBA
                                      ? scaled(value(k.combine_rgb, true) + ".r", k.combine_alpha)
                                      : scaled(value(k.combine_alpha, false), k.combine_alpha);
        return "    c = vec4(" + color + ", " + alpha + ");\n";
    }

private:
    std::string source(GLenum name) const
    {
        switch (name) {
        case GL_TEXTURE:
            return texel(unit_);
        case GL_CONSTANT:
            return texturing(unit_, texturing_layout::ENVIRONMENT_COLOR);
        case GL_PRIMARY_COLOR:
            return "primary";
        case GL_PREVIOUS:
            return "c";
        default: { // GL_TEXTURE0 …: another unit's texel, undefined when that unit has none.
            const int other = static_cast<int>(name) - GL_TEXTURE0;
            const bool there =
                other >= 0 && other < TEXTURE_UNIT_COUNT && key_.textures[other].format != BaseFormat::none;
            return there ? texel(other) : "vec4(0.0)";
        }
        }
    }

    std::string argument(const Combine& combine, int i, bool color) const
    {
        const std::string s = source(combine.sources[i]);
        switch (combine.operands[i]) {
        case GL_SRC_COLOR:
            return s + (color ? ".rgb" : ".a");
        case GL_ONE_MINUS_SRC_COLOR:
            return std::string(color ? "(vec3(1.0) - " : "(1.0 - ") + s + (color ? ".rgb)" : ".a)");
        case GL_ONE_MINUS_SRC_ALPHA:
            return color ? "vec3(1.0 - " + s + ".a)" : "(1.0 - " + s + ".a)";
        default:
            return color ? "vec3(" + s + ".a)" : s + ".a";
        }
    }

    std::string value(const Combine& combine, bool color) const
    {
        const auto a = [&](int i) { return argument(combine, i, color); };
        switch (combine.function) {
        case GL_REPLACE:
            return a(0);
        case GL_ADD:
            return a(0) + " + " + a(1);
        case GL_ADD_SIGNED:
            return a(0) + " + " + a(1) + " - 0.5";
        case GL_INTERPOLATE:
            return a(0) + " * " + a(2) + " + " + a(1) + " * (1.0 - " + a(2) + ")";
        case GL_SUBTRACT:
            return a(0) + " - " + a(1);
        case GL_DOT3_RGB:
        case GL_DOT3_RGBA:
            return "vec3(dot(" + a(0) + " * 2.0 - 1.0, " + a(1) + " * 2.0 - 1.0))";
        default: // GL_MODULATE
            return a(0) + " * " + a(1);
        }
    }

    static std::string scaled(const std::string& value, const Combine& combine)
    {
        const std::string factor = std::to_string(static_cast<int>(combine.scale)) + ".0";
        return "clamp((" + value + ") * " + factor + ", 0.0, 1.0)";
    }

    const ShaderKey& key_;
    int unit_;
};

/// Returns the beginning of a call that looks a texel up.
std::string lookup(const TextureKey& texture, int unit)
{
    const std::string number = std::to_string(unit), place = "texture_position_" + number;
    if (!texture.clamps()) {
        return "textureProj(texture_" + number + ", " + place;
    }
    const auto along = [&](std::size_t i, const char* name) {
        const std::string at = place + name + " / " + place + ".w";
        return texture.border_wrap[i] ? "clamp(" + at + ", 0.0, 1.0)" : at;
    };
    return "texture(texture_" + number + ", vec2(" + along(0, ".x") + ", " + along(1, ".y") + ")";
}

} // namespace

std::string texture_coordinate_text(const ShaderKey& key, int unit)
{
    using namespace texturing_layout;
    const TextureKey& texture = key.textures[unit];
    const std::string number = std::to_string(unit), in = "texture_coordinate_" + number, c = "s" + number;
    std::string text = "    vec4 " + c + " = " + in + ";\n";
    for (int i = 0; i < 4; ++i) {
        const std::string component = c + "." + "xyzw"[i];
        if (texture.generation[i] == GL_OBJECT_LINEAR) {
            text += "    " + component + " = dot(position, " + texturing(unit, OBJECT_PLANES + i) + ");\n";
        } else if (texture.generation[i] == GL_EYE_LINEAR) {
            text += "    " + component + " = dot(eye, " + texturing(unit, EYE_PLANES + i) + ");\n";
        } else if (texture.generation[i] == GL_SPHERE_MAP) {
            text += "    " + component + " = sphere." + "xyzw"[i] + ";\n";
        }
    }
    const std::string out = "texture_position_" + number;
    text += "    " + out + " = " +
            (texture.matrix
                 ? columns_times([&](int i) { return at("texturing", unit * UNIT_SIZE + MATRIX + i); }, c)
                 : c) +
            ";\n";
    // A 1D texture is one texel high: t must neither matter nor count for the level of detail.
    return texture.one_dimensional ? text + "    " + out + ".y = 0.0;\n" : text;
}

std::string texture_environment_text(const ShaderKey& key)
{
    std::string text = "    vec4 primary = c;\n";
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].format != BaseFormat::none) {
            text += "    vec4 " + texel(unit) + " = " + lookup(key.textures[unit], unit) +
                    (key.textures[unit].lod_bias ? ", " + texturing(unit, texturing_layout::LOD_BIAS) + ".x"
                                                 : "") +
                    ");\n" + border_text(key, unit);
        }
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        const TextureKey& texture = key.textures[unit];
        if (texture.format != BaseFormat::none) {
            text += texture.environment == GL_COMBINE ? CombineText(key, unit).text()
                                                      : simple_environment(texture, unit);
        }
    }
    return text;
}

} // namespace legacygl
