#include "legacygl/shader_text.h"

#include <string>

namespace legacygl {
namespace {

std::string at(const char* group, int index)
{
    return std::string(group) + '[' + std::to_string(index) + ']';
}

std::string transform(int index)
{
    return at("transform", index);
}

std::string lighting(int index)
{
    return at("lighting", index);
}

/// column 0 · v.x + column 1 · v.y + …, added in that order.
std::string columns_times(const char* group, int first, const std::string& v)
{
    return v + ".x * " + at(group, first) + " + " + v + ".y * " + at(group, first + 1) + " + " + v + ".z * " +
           at(group, first + 2) + " + " + v + ".w * " + at(group, first + 3);
}

/// Writes the lighting of one vertex (OpenGL 1.5, 2.14.1).
class LightingText
{
public:
    explicit LightingText(const ShaderKey& key) : key_(key), layout_(key) {}

    std::string text()
    {
        add_normal();
        if (key_.needs_eye_position())
            line("vec4 eye = " + columns_times("transform", layout_.modelview, "position") + ";");
        if (key_.local_viewer && key_.specular)
            line("vec3 eye_direction = eye.xyz * inversesqrt(dot(eye.xyz, eye.xyz));");
        for (int face = 0; face < faces(); ++face)
            add_scene_color(face);
        for (int i = 0; i < key_.light_count; ++i)
            add_light(i);
        return text_;
    }

private:
    int faces() const { return key_.two_side ? 2 : 1; }
    void line(const std::string& s) { text_ += "    " + s + "\n"; }

    static std::string face_value(int face, int which)
    {
        using namespace lighting_layout;
        return lighting(FACE + face * FACE_SIZE + which);
    }
    std::string material(int face, MaterialProperty property, int which) const
    {
        return key_.follows(face, property) ? "color" : face_value(face, which);
    }
    static std::string primary(int face) { return face == 0 ? "front_color" : "back_color"; }
    static std::string secondary(int face) { return face == 0 ? "front_secondary" : "back_secondary"; }

    void add_normal()
    {
        line("vec3 n = normal;");
        if (key_.eye_space)
            line("n = vec3(dot(n, " + transform(layout_.normal) + ".xyz), dot(n, " +
                 transform(layout_.normal + 1) + ".xyz), dot(n, " + transform(layout_.normal + 2) +
                 ".xyz));");
        if (key_.normalize)
            line("n = n * inversesqrt(dot(n, n));");
        else if (key_.needs_normal_scale())
            line("n = n * " + transform(layout_.normal_scale) + ".x;");
    }

    void add_scene_color(int face)
    {
        using namespace lighting_layout;
        using enum MaterialProperty;
        if (key_.follows(face, emission) || key_.follows(face, ambient) || key_.follows(face, diffuse))
            line(primary(face) + " = vec4((" + lighting(MODEL_AMBIENT) + " * " +
                 material(face, ambient, FACE_AMBIENT) + " + " + material(face, emission, FACE_EMISSION) +
                 ").rgb, " + material(face, diffuse, FACE_DIFFUSE) + ".a);");
        else
            line(primary(face) + " = " + face_value(face, SCENE_COLOR) + ";");
        if (key_.separate_specular)
            line(secondary(face) + " = vec4(0.0, 0.0, 0.0, 1.0);");
    }

    void add_light(int i)
    {
        using namespace lighting_layout;
        const LightKey& light = key_.lights[i];
        const int base = LIGHT + i * LIGHT_SIZE;
        const bool attenuated = light.spot || (light.attenuated && light.positional);
        line("{");
        if (!key_.eye_space) {
            line("vec3 direction = " + transform(layout_.object_lights + 2 * i) + ".xyz;");
        } else if (!light.positional) {
            line("vec3 direction = " + lighting(base + POSITION) + ".xyz;");
        } else {
            line("vec3 direction = " + lighting(base + POSITION) + ".xyz - eye.xyz;");
            line("float distance_reciprocal = inversesqrt(dot(direction, direction));");
            line("direction = direction * distance_reciprocal;");
        }
        add_attenuation(light, base);
        add_half_vector(i, light, base);
        line("float n_direction = dot(n, direction);");
        for (int face = 0; face < faces(); ++face)
            add_face(face, base, attenuated);
        line("}");
    }

    void add_attenuation(const LightKey& light, int base)
    {
        using namespace lighting_layout;
        const std::string attenuation = lighting(base + ATTENUATION);
        if (light.spot) {
            const std::string spot = lighting(base + SPOT);
            line("float spot = dot(-direction, " + spot + ".xyz);");
            line("float attenuation = " + spot + ".w < spot ? pow(spot, " + attenuation + ".w) : 0.0;");
        }
        if (light.attenuated && light.positional) {
            line("float d = 1.0 / distance_reciprocal;");
            const std::string factor = "1.0 / dot(vec3(1.0, d, d * d), " + attenuation + ".xyz)";
            line(light.spot ? "attenuation = (" + factor + ") * attenuation;"
                            : "float attenuation = " + factor + ";");
        }
    }

    void add_half_vector(int i, const LightKey& light, int base)
    {
        using namespace lighting_layout;
        if (!key_.specular)
            return;
        if (key_.local_viewer)
            line("vec3 h = direction - eye_direction;");
        else if (!key_.eye_space)
            line("vec3 h = " + transform(layout_.object_lights + 2 * i + 1) + ".xyz;");
        else if (!light.positional)
            line("vec3 h = " + lighting(base + HALF_VECTOR) + ".xyz;");
        else
            line("vec3 h = direction + vec3(0.0, 0.0, 1.0);");
        if (key_.local_viewer || light.positional)
            line("h = h * inversesqrt(dot(h, h));");
        line("float n_half = dot(n, h);");
    }

    void add_face(int face, int base, bool attenuated)
    {
        using namespace lighting_layout;
        using enum MaterialProperty;
        const std::string sign = face == 0 ? "" : "-";
        const auto product = [&](MaterialProperty property, int which) {
            const std::string value = lighting(base + PRODUCT + face * 3 + static_cast<int>(property));
            return key_.follows(face, property)
                       ? "(" + value + " * " + material(face, property, which) + ").rgb"
                       : value + ".rgb";
        };
        const std::string out = primary(face);
        line("{");
        line("float x = " + sign + "n_direction;");
        line("float diffuse = max(0.0, x);");
        if (key_.specular)
            line("float specular = 0.0 >= x ? 0.0 : pow(max(" + sign + "n_half, 0.0), " +
                 face_value(face, FACE_SHININESS) + ".x);");
        else
            line("float specular = 0.0 < x ? 1.0 : 0.0;");
        if (attenuated) {
            line("diffuse = diffuse * attenuation;");
            line("specular = specular * attenuation;");
            line(out + ".rgb = attenuation * " + product(ambient, FACE_AMBIENT) + " + " + out + ".rgb;");
        } else {
            line(out + ".rgb = " + product(ambient, FACE_AMBIENT) + " + " + out + ".rgb;");
        }
        line(out + ".rgb = diffuse * " + product(diffuse, FACE_DIFFUSE) + " + " + out + ".rgb;");
        const std::string into = key_.separate_specular ? secondary(face) : out;
        line(into + ".rgb = specular * " + product(specular, FACE_SPECULAR) + " + " + into + ".rgb;");
        line("}");
    }

    const ShaderKey& key_;
    TransformLayout layout_;
    std::string text_;
};

/// The varyings between the shaders, in the direction given ("out" or "in").
std::string varyings(const ShaderKey& key, const char* direction)
{
    const std::string prefix = std::string(key.flat ? "flat " : "") + direction + " vec4 ";
    std::string text = prefix + "front_color;\n";
    if (key.lighting && key.two_side)
        text += prefix + "back_color;\n";
    if (key.lighting && key.separate_specular) {
        text += prefix + "front_secondary;\n";
        if (key.two_side)
            text += prefix + "back_secondary;\n";
    }
    if (key.texture != BaseFormat::none)
        text += std::string(direction) + " vec4 texture_position;\n";
    return text;
}

/// Puts a point's centre where OpenGL 1.5, 3.3.1, rounds it to, and drops it when that lies outside the
/// clip volume: ES rasterises sprites, whose centres are not rounded.
std::string point_text(const TransformLayout& layout)
{
    const std::string viewport = transform(layout.point), size = transform(layout.point + 1) + ".x";
    return "    gl_PointSize = " + size + ";\n" +
           "    vec3 limit = abs(gl_Position.xyz);\n"
           "    if (max(limit.x, max(limit.y, limit.z)) > gl_Position.w) {\n"
           "        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);\n"
           "    } else {\n"
           "        vec2 window = (gl_Position.xy / gl_Position.w * 0.5 + 0.5) * " +
           viewport +
           ".zw;\n"
           "        window = mod(" +
           size +
           ", 2.0) == 1.0 ? floor(window) + 0.5 : floor(window + 0.5);\n"
           "        gl_Position.xy = (window / " +
           viewport +
           ".zw * 2.0 - 1.0) * gl_Position.w;\n"
           "    }\n";
}

std::string vertex_text(const ShaderKey& key)
{
    const TransformLayout layout(key);
    std::string text = "#version 300 es\n"
                       "precision highp float;\n"
                       "invariant gl_Position;\n"
                       "layout(location = 0) in vec4 position;\n"
                       "layout(location = 1) in vec3 normal;\n"
                       "layout(location = 2) in vec4 color;\n"
                       "layout(location = 3) in vec4 texture_coordinate;\n";
    text += "uniform vec4 transform[" + std::to_string(layout.size) + "];\n";
    if (key.lighting)
        text += "uniform vec4 lighting[" + std::to_string(lighting_layout::size(key.light_count)) + "];\n";
    if (key.texture_matrix)
        text += "uniform vec4 texturing[" + std::to_string(texturing_layout::SIZE) + "];\n";
    text += varyings(key, "out");
    text += "void main()\n{\n";
    text +=
        "    gl_Position = " + columns_times("transform", layout.projection_modelview, "position") + ";\n";
    text += key.lighting ? LightingText(key).text() : "    front_color = color;\n";
    text += "    front_color = clamp(front_color, 0.0, 1.0);\n";
    if (key.lighting && key.two_side)
        text += "    back_color = clamp(back_color, 0.0, 1.0);\n";
    if (key.lighting && key.separate_specular) {
        text += "    front_secondary = clamp(front_secondary, 0.0, 1.0);\n";
        if (key.two_side)
            text += "    back_secondary = clamp(back_secondary, 0.0, 1.0);\n";
    }
    if (key.texture != BaseFormat::none)
        text +=
            "    texture_position = " +
            (key.texture_matrix ? columns_times("texturing", texturing_layout::MATRIX, "texture_coordinate")
                                : std::string("texture_coordinate")) +
            ";\n";
    if (key.points)
        text += point_text(layout);
    return text + "}\n";
}

/// Writes the texture environment (OpenGL 1.5, tables 3.22 and 3.23): c is the fragment, t the texel.
std::string environment_text(const ShaderKey& key)
{
    const bool has_color = key.texture != BaseFormat::alpha;
    const bool has_alpha = key.texture != BaseFormat::rgb && key.texture != BaseFormat::luminance;
    const std::string environment = at("texturing", texturing_layout::ENVIRONMENT_COLOR);
    std::string color = "c.rgb", alpha = "c.a";
    switch (key.texture_environment) {
    case GL_REPLACE:
        color = has_color ? "t.rgb" : color;
        alpha = has_alpha ? "t.a" : alpha;
        break;
    case GL_DECAL:
        if (key.texture == BaseFormat::rgb)
            color = "t.rgb";
        else if (key.texture == BaseFormat::rgba)
            color = "c.rgb * (1.0 - t.a) + t.rgb * t.a";
        break;
    case GL_BLEND:
        if (has_color)
            color = "c.rgb * (1.0 - t.rgb) + " + environment + ".rgb * t.rgb";
        if (key.texture == BaseFormat::intensity)
            alpha = "c.a * (1.0 - t.a) + " + environment + ".a * t.a";
        else if (has_alpha)
            alpha = "c.a * t.a";
        break;
    default: // GL_MODULATE
        color = has_color ? "c.rgb * t.rgb" : color;
        alpha = has_alpha ? "c.a * t.a" : alpha;
        break;
    }
    return "    c = vec4(" + color + ", " + alpha + ");\n";
}

std::string fragment_text(const ShaderKey& key)
{
    const bool two_side = key.lighting && key.two_side;
    std::string text = "#version 300 es\n"
                       "precision highp float;\n"
                       "precision highp sampler2D;\n";
    text += varyings(key, "in");
    if (key.texture != BaseFormat::none)
        text += "uniform sampler2D texture_0;\nuniform vec4 texturing[" +
                std::to_string(texturing_layout::SIZE) + "];\n";
    text += "out vec4 fragment_color;\nvoid main()\n{\n";
    text += two_side ? "    vec4 c = gl_FrontFacing ? front_color : back_color;\n"
                     : "    vec4 c = front_color;\n";
    if (key.texture != BaseFormat::none) {
        text += "    vec4 t = textureProj(texture_0, texture_position);\n";
        text += environment_text(key);
    }
    if (key.lighting && key.separate_specular)
        text += two_side ? "    c.rgb += (gl_FrontFacing ? front_secondary : back_secondary).rgb;\n"
                         : "    c.rgb += front_secondary.rgb;\n";
    return text + "    fragment_color = c;\n}\n";
}

} // namespace

ProgramText make_program_text(const ShaderKey& key)
{
    return {vertex_text(key), fragment_text(key)};
}

} // namespace legacygl
