#include "legacygl/shader/shader_lighting_text.h"

#include "legacygl/shader/shader_words.h"

namespace legacygl {
namespace {

std::string lighting(int index)
{
    return at("lighting", index);
}

/// Writes the lighting of one vertex (OpenGL 1.5, 2.14.1).
class LightingText
{
public:
    explicit LightingText(const ShaderKey& key) : key_(key), layout_(key) {}

    std::string text()
    {
        if (key_.local_viewer && key_.specular) {
            line("vec3 eye_direction = eye.xyz * inversesqrt(dot(eye.xyz, eye.xyz));");
        }
        for (int face = 0; face < faces(); ++face) {
            add_scene_color(face);
        }
        for (int i = 0; i < key_.light_count; ++i) {
            add_light(i);
        }
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

    void add_scene_color(int face)
    {
        using namespace lighting_layout;
        using enum MaterialProperty;
        if (key_.follows(face, emission) || key_.follows(face, ambient) || key_.follows(face, diffuse)) {
            line(primary(face) + " = vec4((" + lighting(MODEL_AMBIENT) + " * " +
                 material(face, ambient, FACE_AMBIENT) + " + " + material(face, emission, FACE_EMISSION) +
                 ").rgb, " + material(face, diffuse, FACE_DIFFUSE) + ".a);");
        } else {
            line(primary(face) + " = " + face_value(face, SCENE_COLOR) + ";");
        }
        if (key_.separate_specular) {
            line(secondary(face) + " = vec4(0.0, 0.0, 0.0, 1.0);");
        }
    }

    void add_light(int i)
    {
        using namespace lighting_layout;
        const LightKey& light = key_.lights[i];
        const int base = LIGHT + i * LIGHT_SIZE;
        const bool attenuated = light.spot || (light.attenuated && light.positional);
        line("{");
        if (!key_.eye_space) {
            line("vec3 direction = " + of_transform(layout_.object_lights + 2 * i) + ".xyz;");
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
        for (int face = 0; face < faces(); ++face) {
            add_face(face, base, attenuated);
        }
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
        if (!key_.specular) {
            return;
        }
        if (key_.local_viewer) {
            line("vec3 h = direction - eye_direction;");
        } else if (!key_.eye_space) {
            line("vec3 h = " + of_transform(layout_.object_lights + 2 * i + 1) + ".xyz;");
        } else if (!light.positional) {
            line("vec3 h = " + lighting(base + HALF_VECTOR) + ".xyz;");
        } else {
            line("vec3 h = direction + vec3(0.0, 0.0, 1.0);");
        }
        if (key_.local_viewer || light.positional) {
            line("h = h * inversesqrt(dot(h, h));");
        }
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
        if (key_.specular) {
            line("float specular = 0.0 >= x ? 0.0 : pow(max(" + sign + "n_half, 0.0), " +
                 face_value(face, FACE_SHININESS) + ".x);");
        } else {
            line("float specular = 0.0 < x ? 1.0 : 0.0;");
        }
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

} // namespace

std::string lighting_text(const ShaderKey& key)
{
    return LightingText(key).text();
}

std::string normal_text(const ShaderKey& key)
{
    const TransformLayout layout(key);
    std::string text = "    vec3 n = normal;\n";
    if (key.eye_space) {
        text += "    n = vec3(dot(n, " + of_transform(layout.normal) + ".xyz), dot(n, " +
                of_transform(layout.normal + 1) + ".xyz), dot(n, " + of_transform(layout.normal + 2) +
                ".xyz));\n";
    }
    if (key.normalize) {
        text += "    n = n * inversesqrt(dot(n, n));\n";
    } else if (key.needs_normal_scale()) {
        text += "    n = n * " + of_transform(layout.normal_scale) + ".x;\n";
    }
    return text;
}

} // namespace legacygl
