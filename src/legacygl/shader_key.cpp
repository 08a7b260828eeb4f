#include "legacygl/shader_key.h"

#include "legacygl/pixel_conversion.h"

#include <cstring>

namespace legacygl {
namespace {

bool shines(const State& state)
{
    if (state.lighting.materials[0].shininess != 0)
        return true;
    return state.lighting.two_side && state.lighting.materials[1].shininess != 0;
}

void add_lighting(const State& state, ShaderKey& key)
{
    const LightingState& lighting = state.lighting;
    key.lighting = true;
    key.local_viewer = lighting.local_viewer;
    key.two_side = lighting.two_side;
    key.separate_specular = lighting.separate_specular;
    key.normalize = state.transform.normalize;
    key.rescale = state.transform.rescale_normal;
    key.specular = shines(state);
    key.eye_space = lighting.local_viewer || lighting.separate_specular ||
                    !state.transform.modelview.top().preserves_length();
    for (const Light& light : lighting.lights) {
        if (!light.enabled)
            continue;
        LightKey& k = key.lights[key.light_count++];
        k.positional = light.position.w != 0;
        k.spot = light.spot_cutoff_degrees != 180;
        k.attenuated = light.attenuation != std::array<float, 3>{1, 0, 0};
        key.eye_space |= k.positional || k.spot;
    }
    for (int face = 0; face < 2; ++face)
        for (int p = 0; p < MATERIAL_PROPERTY_COUNT; ++p)
            if (lighting.follows_color(face, static_cast<MaterialProperty>(p)))
                key.follows_color |= static_cast<std::uint8_t>(1u << (face * MATERIAL_PROPERTY_COUNT + p));
}

} // namespace

ShaderKey make_shader_key(const State& state, PrimitiveClass primitive)
{
    ShaderKey key;
    key.flat = state.lighting.shade_model == GL_FLAT;
    key.points = primitive == PrimitiveClass::points;
    if (state.lighting.enabled)
        add_lighting(state, key);
    if (state.texturing.enabled_2d && state.texturing.bound().complete()) {
        key.texture = base_format(state.texturing.bound().levels[0].internal_format);
        key.texture_environment = state.texturing.environment_mode;
        key.texture_matrix =
            std::memcmp(state.transform.texture.top().values(), Matrix().values(), sizeof(float) * 16) != 0;
    }
    return key;
}

std::uint32_t attributes_read(const ShaderKey& key)
{
    std::uint32_t mask = 1u << index_of(Attribute::position);
    if (key.lighting)
        mask |= 1u << index_of(Attribute::normal);
    if (!key.lighting || key.follows_color)
        mask |= 1u << index_of(Attribute::color);
    if (key.texture != BaseFormat::none)
        mask |= 1u << index_of(Attribute::texture_coordinate);
    return mask;
}

TransformLayout::TransformLayout(const ShaderKey& key)
{
    const auto place = [this](int& where, int count) {
        where = size;
        size += count;
    };
    if (key.needs_eye_position())
        place(modelview, 4);
    if (key.lighting && key.eye_space)
        place(normal, 3);
    if (key.needs_normal_scale())
        place(normal_scale, 1);
    if (key.lighting && !key.eye_space)
        place(object_lights, 2 * key.light_count);
    if (key.points)
        place(point, 2);
}

std::size_t ShaderKeyHash::operator()(const ShaderKey& key) const
{
    // FNV-1a over the members; never over the object's memory, which has padding.
    std::uint64_t hash = 14695981039346656037ull;
    const auto mix = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ull; };
    for (bool b : {key.lighting, key.eye_space, key.normalize, key.rescale, key.local_viewer, key.two_side,
                   key.separate_specular, key.specular, key.texture_matrix, key.flat, key.points})
        mix(b);
    mix(key.follows_color);
    mix(key.light_count);
    for (const LightKey& light : key.lights)
        mix(light.positional | light.spot << 1 | light.attenuated << 2);
    mix(static_cast<std::uint64_t>(key.texture));
    mix(key.texture_environment);
    return static_cast<std::size_t>(hash);
}

} // namespace legacygl
