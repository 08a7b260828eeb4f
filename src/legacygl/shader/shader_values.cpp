#include "legacygl/shader/shader_values.h"

#include "legacygl/state/internal_format.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace legacygl {
namespace {

constexpr double PI = 3.14159265358979323846;

glm::vec4 column(const float* m, int i)
{
    return {m[4 * i], m[4 * i + 1], m[4 * i + 2], m[4 * i + 3]};
}

/// The length's reciprocal is computed first, as Mesa does; a vector without length stays.
glm::vec3 normalized(glm::vec3 v)
{
    const float squared = v.x * v.x + v.y * v.y + v.z * v.z;
    if (squared == 0) {
        return v;
    }
    const float reciprocal = 1.0f / std::sqrt(squared);
    return {v.x * reciprocal, v.y * reciprocal, v.z * reciprocal};
}

glm::vec3 transform_point(const float* m, const glm::vec4& p)
{
    glm::vec3 out;
    for (int row = 0; row < 3; ++row) {
        out[row] = m[row] * p[0] + m[row + 4] * p[1] + m[row + 8] * p[2] + m[row + 12] * p[3];
    }
    return out;
}

/// What the normal is multiplied by when it is rescaled, or when light in object coordinates meets a
/// modelview that scales (OpenGL 1.5, 2.11.3).
float normal_scale(const Matrix& modelview, bool eye_space)
{
    if (modelview.preserves_length()) {
        return 1;
    }
    const float* inverse = modelview.inverse();
    float f = inverse[2] * inverse[2] + inverse[6] * inverse[6] + inverse[10] * inverse[10];
    if (f < 1e-12f) {
        f = 1;
    }
    return eye_space ? 1.0f / std::sqrt(f) : std::sqrt(f);
}

/// Direction to an infinite light and the half vector towards the viewer along z.
struct InfiniteLight
{
    glm::vec3 direction, half_vector;
};

InfiniteLight infinite_light(glm::vec3 position, glm::vec3 towards_viewer)
{
    const glm::vec3 direction = normalized(position);
    return {direction, normalized(direction + towards_viewer)};
}

/// Returns what blending multiplies the source's colours by, in 255ths (OpenGL 1.5, table 4.2).
glm::vec4 blend_weight(const BlendState& blend)
{
    if (blend.equation == GL_MIN || blend.equation == GL_MAX) {
        return glm::vec4(255); // No factor counts.
    }
    const bool by_color =
        blend.source_rgb == GL_CONSTANT_COLOR || blend.source_rgb == GL_ONE_MINUS_CONSTANT_COLOR;
    const bool complement =
        blend.source_rgb == GL_ONE_MINUS_CONSTANT_COLOR || blend.source_rgb == GL_ONE_MINUS_CONSTANT_ALPHA;
    glm::vec4 weight;
    for (int i = 0; i < 4; ++i) {
        const float constant = std::floor((by_color ? blend.color[i] : blend.color.a) * 255.0f + 0.5f);
        weight[i] = complement ? 255.0f - constant : constant;
    }
    return weight;
}

} // namespace

float rasterised_point_size(float size)
{
    // In steps of 1/256, halves down: what Mesa's renderer does with the points of OpenGL 1.
    const float steps = std::floor(size * 256.0f + 0.5f);
    return std::max(1.0f, std::floor((steps + 127.0f) / 256.0f));
}

void fill_transform(const State& state, const ShaderKey& key, const TransformLayout& layout,
                    std::span<glm::vec4> out)
{
    const Matrix& modelview = state.transform.modelview.top();
    const Matrix both = Matrix::product(state.transform.projection.top(), modelview);
    for (int i = 0; i < 4; ++i) {
        out[layout.projection_modelview + i] = column(both.values(), i);
    }
    if (layout.modelview >= 0) {
        for (int i = 0; i < 4; ++i) {
            out[layout.modelview + i] = column(modelview.values(), i);
        }
    }
    if (layout.normal >= 0) {
        for (int i = 0; i < 3; ++i) {
            out[layout.normal + i] = column(modelview.inverse(), i);
        }
    }
    if (layout.normal_scale >= 0) {
        out[layout.normal_scale] = glm::vec4(normal_scale(modelview, key.eye_space));
    }
    if (layout.object_lights >= 0) {
        const float* m = modelview.values();
        const glm::vec3 towards_viewer = {m[2], m[6], m[10]};
        int at = layout.object_lights;
        for (const Light& light : state.lighting.lights) {
            if (!light.enabled) {
                continue;
            }
            const InfiniteLight l =
                infinite_light(transform_point(modelview.inverse(), light.position), towards_viewer);
            out[at++] = glm::vec4(l.direction, 0);
            out[at++] = glm::vec4(l.half_vector, 0);
        }
    }
    if (layout.point >= 0) {
        const std::array<GLint, 4>& viewport = state.transform.viewport;
        for (int i = 0; i < 4; ++i) {
            out[layout.point][i] = static_cast<float>(viewport[i]);
        }
        if (key.shaded) { // They are drawn through a viewport grown to all sides.
            for (int i = 2; i < 4; ++i) {
                out[layout.point][i] += 2.0f * VIEWPORT_MARGIN;
            }
        }
        out[layout.point + 1] = glm::vec4(rasterised_point_size(state.raster.clamped_point_size()));
    }
}

void fill_lighting(const LightingState& lighting, const ShaderKey& key, std::span<glm::vec4> out)
{
    using namespace lighting_layout;
    using enum MaterialProperty;
    for (int face = 0; face < 2; ++face) {
        const Material& material = lighting.materials[face];
        glm::vec4* values = &out[FACE + face * FACE_SIZE];
        values[SCENE_COLOR] = lighting.model_ambient * material[ambient] + material[emission];
        values[SCENE_COLOR].a = material[diffuse].a;
        values[FACE_AMBIENT] = material[ambient];
        values[FACE_DIFFUSE] = material[diffuse];
        values[FACE_SPECULAR] = material[specular];
        values[FACE_EMISSION] = material[emission];
        values[FACE_SHININESS] = glm::vec4(material.shininess);
    }
    out[MODEL_AMBIENT] = lighting.model_ambient;

    int at = LIGHT;
    for (const Light& light : lighting.lights) {
        if (!light.enabled) {
            continue;
        }
        glm::vec4* values = &out[at];
        at += LIGHT_SIZE;
        values[POSITION] = values[HALF_VECTOR] = glm::vec4(0);
        if (light.position.w != 0) {
            values[POSITION] = light.position * (1.0f / light.position.w);
        } else {
            const InfiniteLight l = infinite_light(glm::vec3(light.position), {0, 0, 1});
            values[POSITION] = glm::vec4(l.direction, 0);
            values[HALF_VECTOR] = glm::vec4(l.half_vector, 0);
        }
        const double cutoff = static_cast<double>(light.spot_cutoff_degrees) * PI / 180.0;
        const float cosine = static_cast<float>(std::cos(cutoff));
        values[SPOT] = glm::vec4(normalized(light.spot_direction), cosine < 0 ? 0.0f : cosine);
        values[ATTENUATION] = {light.attenuation[0], light.attenuation[1], light.attenuation[2],
                               light.spot_exponent};
        const glm::vec4 colors[3] = {light.ambient, light.diffuse, light.specular};
        for (int face = 0; face < 2; ++face) {
            for (int p = 0; p < 3; ++p) {
                const auto property = static_cast<MaterialProperty>(p);
                values[PRODUCT + face * 3 + p] =
                    key.follows(face, property) ? colors[p] : colors[p] * lighting.materials[face][property];
            }
        }
    }
}

void fill_texturing(const State& state, std::span<glm::vec4> out)
{
    using namespace texturing_layout;
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        const TextureUnit& u = state.texturing.units[unit];
        glm::vec4* values = &out[unit * UNIT_SIZE];
        values[ENVIRONMENT_COLOR] = u.environment_color;
        if (const Texture* texture = state.texturing.used(u)) {
            values[LOD_BIAS] = glm::vec4(TexturingState::lod_bias(u, *texture));
            values[BORDER_COLOR] =
                as_sampled(base_format(texture->base()->internal_format), texture->parameters.border_color);
        }
        for (int i = 0; i < 4; ++i) {
            values[MATRIX + i] = column(state.transform.texture[unit].top().values(), i);
            values[OBJECT_PLANES + i] = u.generation[i].object_plane;
            values[EYE_PLANES + i] = u.generation[i].eye_plane;
        }
    }
}

void fill_fragments(const State& state, glm::vec4 target_copy_origin, std::span<glm::vec4> out)
{
    using namespace fragments_layout;
    constexpr float LOG2_E = 1.44269504088896340736f; // 1 / ln 2, for exp2() instead of exp()
    constexpr float ONE_DIV_SQRT_LN_2 = 1.201122408786449815f;
    const FogState& fog = state.fog;
    const float slope = fog.end == fog.start ? 1.0f : -1.0f / (fog.end - fog.start);
    out[FOG_COLOR] = fog.color;
    out[FOG_FACTORS] = {slope, fog.end * -slope, fog.density * LOG2_E, fog.density * ONE_DIV_SQRT_LN_2};
    out[ALPHA_REFERENCE] = glm::vec4(std::floor(state.fragment.alpha_reference * 255.0f + 0.5f));
    out[TARGET_COPY_ORIGIN] = target_copy_origin;
    out[BLEND_WEIGHT] = blend_weight(state.fragment.blend);
    if (out.size() <= STIPPLE) {
        return;
    }
    const StippleRows& rows = state.raster.polygon_stipple.rows;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        glm::vec4& values = out[STIPPLE + y / 2];
        const int at = y % 2 == 0 ? 0 : 2;
        values[at] = static_cast<float>(rows[y] >> 16);
        values[at + 1] = static_cast<float>(rows[y] & 0xffff);
    }
}

} // namespace legacygl
