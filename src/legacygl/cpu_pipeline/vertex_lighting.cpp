#include "legacygl/cpu_pipeline/vertex_lighting.h"

#include "legacygl/cpu_pipeline/approximate_math.h"

#include <algorithm>
#include <cmath>

namespace legacygl {
namespace {

using namespace lighting_layout;
using enum MaterialProperty;

float dot(const glm::vec3& a, const glm::vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

float inverse_square_root(float x)
{
    return 1.0f / std::sqrt(x);
}

glm::vec3 rgb(const glm::vec4& v)
{
    return {v.x, v.y, v.z};
}

void set_rgb(glm::vec4& to, const glm::vec3& value)
{
    to = {value.x, value.y, value.z, to.w};
}

class VertexLighting
{
public:
    VertexLighting(const ShaderKey& key, const LightingInput& in, Varyings& out)
        : key_(key), layout_(key), in_(in), out_(out)
    {}

    void run()
    {
        if (key_.local_viewer && key_.specular) {
            eye_direction_ = rgb(in_.eye) * inverse_square_root(dot(rgb(in_.eye), rgb(in_.eye)));
        }
        for (int face = 0; face < faces(); ++face) {
            add_scene_color(face);
        }
        for (int i = 0; i < key_.light_count; ++i) {
            add_light(i);
        }
    }

private:
    struct Light
    {
        float n_direction, n_half, attenuation;
        bool attenuated;
    };

    int faces() const { return key_.two_side ? 2 : 1; }
    const glm::vec4& face_value(int face, int which) const
    {
        return in_.lighting[FACE + face * FACE_SIZE + which];
    }
    const glm::vec4& material(int face, MaterialProperty property, int which) const
    {
        return key_.follows(face, property) ? in_.color : face_value(face, which);
    }

    void add_scene_color(int face)
    {
        glm::vec4& color = out_.color[face];
        if (key_.follows(face, emission) || key_.follows(face, ambient) || key_.follows(face, diffuse)) {
            set_rgb(color, rgb(in_.lighting[MODEL_AMBIENT] * material(face, ambient, FACE_AMBIENT) +
                               material(face, emission, FACE_EMISSION)));
            color.a = material(face, diffuse, FACE_DIFFUSE).a;
        } else {
            color = face_value(face, SCENE_COLOR);
        }
        out_.secondary[face] = {0, 0, 0, 1};
    }

    void add_light(int i)
    {
        const LightKey& kind = key_.lights[i];
        const int base = LIGHT + i * LIGHT_SIZE;
        Light light{0, 0, 1, kind.spot || (kind.attenuated && kind.positional)};
        glm::vec3 direction = rgb(key_.eye_space ? in_.lighting[base + POSITION]
                                                 : in_.transform[layout_.object_lights + 2 * i]);
        float distance_reciprocal = 1;
        if (key_.eye_space && kind.positional) {
            direction = direction - rgb(in_.eye);
            distance_reciprocal = inverse_square_root(dot(direction, direction));
            direction = direction * distance_reciprocal;
        }
        if (kind.spot) {
            const glm::vec4& spot = in_.lighting[base + SPOT];
            const float cosine = dot(-direction, rgb(spot));
            light.attenuation =
                spot.w < cosine ? approximate_pow(cosine, in_.lighting[base + ATTENUATION].w) : 0.0f;
        }
        if (kind.attenuated && kind.positional) {
            const float d = 1.0f / distance_reciprocal;
            const float factor = 1.0f / dot({1, d, d * d}, rgb(in_.lighting[base + ATTENUATION]));
            light.attenuation = kind.spot ? factor * light.attenuation : factor;
        }
        light.n_direction = dot(in_.normal, direction);
        light.n_half = key_.specular ? dot(in_.normal, half_vector(i, kind, base, direction)) : 0.0f;
        for (int face = 0; face < faces(); ++face) {
            add_face(face, base, light);
        }
    }

    glm::vec3 half_vector(int i, const LightKey& kind, int base, const glm::vec3& direction) const
    {
        glm::vec3 h;
        if (key_.local_viewer) {
            h = direction - eye_direction_;
        } else if (!key_.eye_space) {
            h = rgb(in_.transform[layout_.object_lights + 2 * i + 1]);
        } else if (!kind.positional) {
            h = rgb(in_.lighting[base + HALF_VECTOR]);
        } else {
            h = direction + glm::vec3(0, 0, 1);
        }
        return key_.local_viewer || kind.positional ? h * inverse_square_root(dot(h, h)) : h;
    }

    glm::vec3 product(int face, int base, MaterialProperty property, int which) const
    {
        const glm::vec4& value = in_.lighting[base + PRODUCT + face * 3 + static_cast<int>(property)];
        return key_.follows(face, property) ? rgb(value * material(face, property, which)) : rgb(value);
    }

    void add_face(int face, int base, const Light& light)
    {
        const float sign = face == 0 ? 1.0f : -1.0f;
        const float x = sign * light.n_direction;
        float diffuse_part = std::max(0.0f, x), specular_part = 0;
        if (key_.specular) {
            specular_part = 0 >= x ? 0.0f
                                   : approximate_pow(std::max(sign * light.n_half, 0.0f),
                                                     face_value(face, FACE_SHININESS).x);
        } else {
            specular_part = 0 < x ? 1.0f : 0.0f;
        }
        glm::vec4& color = out_.color[face];
        const glm::vec3 ambient_part = product(face, base, ambient, FACE_AMBIENT);
        if (light.attenuated) {
            diffuse_part = diffuse_part * light.attenuation;
            specular_part = specular_part * light.attenuation;
            set_rgb(color, light.attenuation * ambient_part + rgb(color));
        } else {
            set_rgb(color, ambient_part + rgb(color));
        }
        set_rgb(color, diffuse_part * product(face, base, diffuse, FACE_DIFFUSE) + rgb(color));
        glm::vec4& into = key_.separate_specular ? out_.secondary[face] : color;
        set_rgb(into, specular_part * product(face, base, specular, FACE_SPECULAR) + rgb(into));
    }

    const ShaderKey& key_;
    const TransformLayout layout_;
    const LightingInput& in_;
    Varyings& out_;
    glm::vec3 eye_direction_{};
};

} // namespace

void light_vertex(const ShaderKey& key, const LightingInput& input, Varyings& out)
{
    VertexLighting(key, input, out).run();
}

} // namespace legacygl
