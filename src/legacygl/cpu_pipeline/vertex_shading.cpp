#include "legacygl/cpu_pipeline/vertex_shading.h"

#include "legacygl/cpu_pipeline/vertex_lighting.h"
#include "legacygl/shader/shader_values.h"

#include <algorithm>
#include <cmath>

namespace legacygl {
namespace {

/// column 0 · v.x + column 1 · v.y + …, added in that order.
glm::vec4 columns_times(const std::vector<glm::vec4>& columns, int first, const glm::vec4& v)
{
    return v.x * columns[first] + v.y * columns[first + 1] + v.z * columns[first + 2] +
           v.w * columns[first + 3];
}

float dot(const glm::vec3& a, const glm::vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

float dot(const glm::vec4& a, const glm::vec4& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

glm::vec4 clamped(const glm::vec4& v)
{
    glm::vec4 out;
    for (int i = 0; i < 4; ++i) {
        out[i] = std::min(std::max(v[i], 0.0f), 1.0f);
    }
    return out;
}

/// Sphere mapping (OpenGL 1.5, 2.11.4), as SPHERE_TEXT of the shader.
glm::vec4 sphere_coordinates(const glm::vec3& n, const glm::vec4& eye)
{
    const glm::vec3 e = {eye.x, eye.y, eye.z};
    const glm::vec3 to_vertex = e * (1.0f / std::sqrt(dot(e, e)));
    float n_twice = dot(n, to_vertex);
    n_twice = n_twice + n_twice;
    const glm::vec3 reflection = -n_twice * n + to_vertex;
    const glm::vec3 half_way = reflection + glm::vec3(0, 0, 1);
    const float scale = 1.0f / std::sqrt(dot(half_way, half_way)) * 0.5f;
    return {reflection.x * scale + 0.5f, reflection.y * scale + 0.5f, reflection.z * scale + 0.5f, 1};
}

/// Reads a vertex of a batch; what the batch lacks stays.
void read_vertex(const VertexBatch& batch, std::uint32_t index, CurrentAttributes& out)
{
    const float* v = batch.vertices.data() + static_cast<std::size_t>(index) * batch.format.floats();
    for (int a = 0; a < ATTRIBUTE_COUNT; ++a) {
        const int components = batch.format.components[a];
        if (components == 0) {
            continue;
        }
        out[a] = {0, 0, 0, 1};
        for (int c = 0; c < components; ++c) {
            out[a][c] = *v++;
        }
    }
}

} // namespace

VertexShading::VertexShading(const State& state, const ShaderKey& key)
    : state_(state), key_(key), layout_(key), viewport_(state.transform), volume_(state.transform),
      lighting_(state.lighting), transform_values_(layout_.size),
      lighting_values_(lighting_layout::size(key.light_count)), texturing_values_(texturing_layout::SIZE)
{
    fill_transform(state, key, layout_, transform_values_);
    fill_lighting_values();
    fill_texturing(state, texturing_values_);
}

/// Without lighting there is no room for the lights that are enabled all the same.
void VertexShading::fill_lighting_values()
{
    if (key_.lighting) {
        fill_lighting(lighting_, key_, lighting_values_);
    }
}

std::vector<ShadedVertex> VertexShading::shade(const VertexBatch& batch)
{
    std::vector<ShadedVertex> out(batch.vertex_count);
    CurrentAttributes attributes = state_.current;
    auto change = batch.material_changes.begin();
    if (change != batch.material_changes.end()) {
        set_materials(batch.materials_before);
    }
    for (std::uint32_t i = 0; i < batch.vertex_count; ++i) {
        for (; change != batch.material_changes.end() && change->vertex == i; ++change) {
            lighting_.set_material(change->face, change->name, change->values);
            fill_lighting_values();
        }
        read_vertex(batch, i, attributes);
        out[i] = shade(attributes);
    }
    return out;
}

void VertexShading::set_materials(const std::array<Material, 2>& materials)
{
    lighting_.materials = materials;
    fill_lighting_values();
}

glm::vec3 VertexShading::eye_normal(const glm::vec4& normal) const
{
    glm::vec3 n = {normal.x, normal.y, normal.z};
    if (key_.eye_space) {
        const auto row = [&](int i) {
            const glm::vec4& r = transform_values_[layout_.normal + i];
            return dot(n, glm::vec3(r.x, r.y, r.z));
        };
        n = {row(0), row(1), row(2)};
    }
    if (key_.normalize) {
        return n * (1.0f / std::sqrt(dot(n, n)));
    }
    return key_.needs_normal_scale() ? n * transform_values_[layout_.normal_scale].x : n;
}

float VertexShading::point_size(const glm::vec4& eye) const
{
    const PointParameters& parameters = state_.raster.point_parameters;
    if (!parameters.attenuates()) {
        return state_.raster.clamped_point_size();
    }
    const float distance = std::fabs(eye.z);
    const std::array<float, 3>& a = parameters.attenuation;
    const float attenuated =
        1.0f / std::sqrt(distance * (distance * a[2] + a[1]) + a[0]) * state_.raster.point_size;
    return std::min(std::min(std::max(attenuated, parameters.minimum), parameters.maximum), MAX_POINT_SIZE);
}

void VertexShading::place(const glm::vec4& position, ShadedVertex& vertex) const
{
    vertex.clip = columns_times(transform_values_, layout_.projection_modelview, position);
    vertex.window = viewport_.window(vertex.clip);
    vertex.outside = volume_.outside(vertex.clip);
}

void VertexShading::texture(int unit, const CurrentAttributes& attributes, const glm::vec4& eye,
                            const glm::vec4& sphere, ShadedVertex& vertex) const
{
    using namespace texturing_layout;
    const TextureKey& texture = key_.textures[unit];
    const int base = unit * UNIT_SIZE;
    glm::vec4 s = attributes[index_of(texture_coordinate(unit))];
    for (int i = 0; i < 4; ++i) {
        if (texture.generation[i] == GL_OBJECT_LINEAR) {
            s[i] = dot(attributes[0], texturing_values_[base + OBJECT_PLANES + i]);
        } else if (texture.generation[i] == GL_EYE_LINEAR) {
            s[i] = dot(eye, texturing_values_[base + EYE_PLANES + i]);
        } else if (texture.generation[i] == GL_SPHERE_MAP) {
            s[i] = sphere[i];
        }
    }
    vertex.varyings.texture[unit] = texture.matrix ? columns_times(texturing_values_, base + MATRIX, s) : s;
}

ShadedVertex VertexShading::shade(const CurrentAttributes& attributes) const
{
    ShadedVertex vertex;
    Varyings& varyings = vertex.varyings;
    const glm::vec4& position = attributes[0];
    const glm::vec4& color = attributes[index_of(Attribute::color)];
    place(position, vertex);
    glm::vec4 eye{0, 0, 0, 1}, sphere{0, 0, 0, 1};
    glm::vec3 normal{0, 0, 1};
    if (layout_.modelview >= 0 || state_.raster.point_parameters.attenuates()) {
        eye = state_.transform.modelview.top().transform(position);
    }
    if (key_.needs_normal()) {
        normal = eye_normal(attributes[index_of(Attribute::normal)]);
    }
    if (key_.lighting) {
        light_vertex(key_, {normal, eye, color, transform_values_, lighting_values_}, varyings);
    } else {
        varyings.color[0] = color;
    }
    if (key_.color_sum) {
        varyings.secondary[0] = attributes[index_of(Attribute::secondary_color)];
    }
    for (std::size_t face = 0; face < 2; ++face) {
        varyings.color[face] = clamped(varyings.color[face]);
        varyings.secondary[face] = clamped(varyings.secondary[face]);
    }
    if (key_.generates(GL_SPHERE_MAP)) {
        sphere = sphere_coordinates(normal, eye);
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key_.textures[unit].format != BaseFormat::none) {
            texture(unit, attributes, eye, sphere, vertex);
        }
    }
    if (key_.fog_mode) {
        varyings.fog =
            key_.fog_coordinate ? attributes[index_of(Attribute::fog_coordinate)].x : std::fabs(eye.z);
    }
    vertex.point_size = point_size(eye);
    vertex.edge_flag = attributes[index_of(Attribute::edge_flag)].x != 0;
    return vertex;
}

} // namespace legacygl
