#include "legacygl/shader/shader_key.h"

#include "legacygl/state/internal_format.h"

#include <cstring>

namespace legacygl {
namespace {

bool shines(const State& state)
{
    if (state.lighting.materials[0].shininess != 0) {
        return true;
    }
    return state.lighting.two_side && state.lighting.materials[1].shininess != 0;
}

void add_lighting(const State& state, ShaderKey& key)
{
    const LightingState& lighting = state.lighting;
    key.lighting = true;
    key.local_viewer = lighting.local_viewer;
    key.two_side = lighting.two_side;
    key.separate_specular = lighting.separate_specular;
    key.specular = shines(state);
    key.eye_space |= lighting.local_viewer || lighting.separate_specular ||
                     !state.transform.modelview.top().preserves_length();
    for (const Light& light : lighting.lights) {
        if (!light.enabled) {
            continue;
        }
        LightKey& k = key.lights[key.light_count++];
        k.positional = light.position.w != 0;
        k.spot = light.spot_cutoff_degrees != 180;
        k.attenuated = light.attenuation != std::array<float, 3>{1, 0, 0};
        key.eye_space |= k.positional || k.spot;
    }
    for (int face = 0; face < 2; ++face) {
        for (int p = 0; p < MATERIAL_PROPERTY_COUNT; ++p) {
            if (lighting.follows_color(face, static_cast<MaterialProperty>(p))) {
                key.follows_color |= static_cast<std::uint8_t>(1u << (face * MATERIAL_PROPERTY_COUNT + p));
            }
        }
    }
}

bool is_identity(const Matrix& matrix)
{
    return std::memcmp(matrix.values(), Matrix().values(), sizeof(float) * 16) == 0;
}

/// With nearest filters GL_CLAMP is GL_CLAMP_TO_EDGE.
void add_border(const Sampling& sampling, TextureKey& key)
{
    const bool nearest = sampling.magnify == GL_NEAREST &&
                         (sampling.minify == GL_NEAREST || sampling.minify == GL_NEAREST_MIPMAP_NEAREST ||
                          sampling.minify == GL_NEAREST_MIPMAP_LINEAR);
    const auto shows = [nearest](GLenum wrap) {
        return wrap == GL_CLAMP_TO_BORDER || (wrap == GL_CLAMP && !nearest) ? wrap : 0;
    };
    key.border_wrap = {shows(sampling.wrap_s), key.one_dimensional ? 0 : shows(sampling.wrap_t)};
    if (key.has_border()) {
        key.minify = sampling.minify;
        key.magnify = sampling.magnify;
    }
}

void add_texture(const State& state, int unit, std::uint32_t varying, ShaderKey& key)
{
    const TextureUnit& u = state.texturing.units[unit];
    const Texture* texture = state.texturing.used(u);
    if (!texture) {
        return;
    }
    TextureKey& k = key.textures[unit];
    k.format = base_format(texture->base()->internal_format);
    k.environment = u.environment_mode;
    if (k.environment == GL_COMBINE) {
        k.combine_rgb = u.combine_rgb;
        k.combine_alpha = u.combine_alpha;
    }
    k.matrix = !is_identity(state.transform.texture[unit].top());
    for (int i = 0; i < 4; ++i) {
        if (u.generation[i].enabled) {
            k.generation[i] = u.generation[i].mode;
        }
    }
    k.lod_bias = TexturingState::lod_bias(u, *texture) != 0;
    k.one_dimensional = texture->target == GL_TEXTURE_1D;
    k.constant = k.takes_one_coordinate(unit, varying);
    add_border(texture->parameters.sampling, k);
}

} // namespace

bool ShaderKey::textured() const
{
    for (const TextureKey& texture : textures) {
        if (texture.format != BaseFormat::none) {
            return true;
        }
    }
    return false;
}

bool ShaderKey::generates(GLenum mode) const
{
    for (const TextureKey& texture : textures) {
        if (texture.generates(mode)) {
            return true;
        }
    }
    return false;
}

bool ShaderKey::needs_eye_position() const
{
    if ((fog_mode && !fog_coordinate) || generates(GL_EYE_LINEAR) || generates(GL_SPHERE_MAP)) {
        return true;
    }
    if (!lighting) {
        return false;
    }
    for (int i = 0; i < light_count; ++i) {
        if (lights[i].positional) {
            return true;
        }
    }
    return local_viewer;
}

bool ShaderKey::needs_normal() const
{
    return lighting || generates(GL_SPHERE_MAP);
}

bool takes_one_color(const State& state, std::uint32_t varying)
{
    const LightingState& lighting = state.lighting;
    return lighting.shade_model == GL_FLAT ||
           (!lighting.enabled && !lighting.color_sum && !(varying & bit_of(Attribute::color)));
}

ShaderKey make_shader_key(const State& state, PrimitiveClass primitive, std::uint32_t varying)
{
    ShaderKey key;
    key.flat = takes_one_color(state, varying);
    key.points = primitive == PrimitiveClass::points;
    key.polygon_stipple = primitive == PrimitiveClass::triangles && state.raster.polygon_stipple.enabled;
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        add_texture(state, unit, varying, key);
    }
    key.eye_space = key.generates(GL_SPHERE_MAP) || key.generates(GL_EYE_LINEAR);
    if (state.lighting.enabled) {
        add_lighting(state, key);
    } else {
        key.color_sum = state.lighting.color_sum;
    }
    if (key.needs_normal()) {
        key.normalize = state.transform.normalize;
        key.rescale = state.transform.rescale_normal;
    }
    if (state.fog.enabled) {
        key.fog_mode = state.fog.mode;
        key.fog_coordinate = state.fog.coordinate_source == GL_FOG_COORDINATE;
    }
    if (state.fragment.alpha_test) {
        key.alpha_func = state.fragment.alpha_func;
    }
    key.blend_weight = !state.fragment.color_logic_op && state.fragment.blend.weighs_by_both_constants();
    key.both_buffers = state.fragment.draws_front() && state.fragment.draws_back();
    return key;
}

bool keeps_length(const State& state)
{
    return state.lighting.enabled && state.transform.modelview.top().preserves_length();
}

ShaderKey make_shaded_key(const ShaderKey& shading, PrimitiveClass primitive, Coverage coverage,
                          bool polygon_stipple, GLenum logic_op)
{
    ShaderKey key;
    key.shaded = true;
    key.points = primitive == PrimitiveClass::points;
    key.polygon_stipple = polygon_stipple;
    key.coverage = coverage;
    key.logic_op = logic_op;
    key.flat = shading.flat;
    key.both_buffers = shading.both_buffers;
    key.color_sum = shading.secondary();
    key.fog_mode = shading.fog_mode;
    key.fog_coordinate = shading.fog_mode != 0;
    key.alpha_func = shading.alpha_func;
    key.blend_weight = shading.blend_weight;
    key.textures = shading.textures;
    for (TextureKey& texture : key.textures) {
        texture.matrix = false;
        texture.generation = {};
    }
    return key;
}

std::uint32_t attributes_read(const ShaderKey& key)
{
    const auto bit = [](Attribute attribute) { return 1u << index_of(attribute); };
    std::uint32_t mask = bit(Attribute::position);
    if (key.needs_normal()) {
        mask |= bit(Attribute::normal);
    }
    if (!key.lighting || key.follows_color) {
        mask |= bit(Attribute::color);
    }
    if (key.color_sum) {
        mask |= bit(Attribute::secondary_color);
    }
    if (key.fog_mode && key.fog_coordinate) {
        mask |= bit(Attribute::fog_coordinate);
    }
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].format != BaseFormat::none) {
            mask |= bit(texture_coordinate(unit));
        }
    }
    return mask;
}

TransformLayout::TransformLayout(const ShaderKey& key)
{
    const auto place = [this](int& where, int count) {
        where = size;
        size += count;
    };
    if (key.needs_eye_position()) {
        place(modelview, 4);
    }
    if (key.needs_normal() && key.eye_space) {
        place(normal, 3);
    }
    if (key.needs_normal_scale()) {
        place(normal_scale, 1);
    }
    if (key.lighting && !key.eye_space) {
        place(object_lights, 2 * key.light_count);
    }
    if (key.points) {
        place(point, 2);
    }
}

std::size_t ShaderKeyHash::operator()(const ShaderKey& key) const
{
    // FNV-1a over the members; never over the object's memory, which has padding.
    std::uint64_t hash = 14695981039346656037ull;
    const auto mix = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ull; };
    for (bool b : {key.lighting, key.eye_space, key.normalize, key.rescale, key.local_viewer, key.two_side,
                   key.separate_specular, key.specular, key.color_sum, key.fog_coordinate, key.flat,
                   key.points, key.polygon_stipple, key.shaded, key.both_buffers, key.blend_weight}) {
        mix(b);
    }
    mix(static_cast<std::uint64_t>(key.coverage));
    mix(key.logic_op);
    mix(key.follows_color);
    mix(key.light_count);
    for (int i = 0; i < key.light_count; ++i) {
        mix(key.lights[i].positional | key.lights[i].spot << 1 | key.lights[i].attenuated << 2);
    }
    mix(key.fog_mode);
    mix(key.alpha_func);
    for (const TextureKey& texture : key.textures) {
        mix(static_cast<std::uint64_t>(texture.format));
        mix(texture.environment);
        mix(texture.matrix);
        mix(texture.one_dimensional | texture.lod_bias << 1 | texture.constant << 2);
        mix(texture.border_wrap[0] | static_cast<std::uint64_t>(texture.border_wrap[1]) << 32);
        mix(texture.minify | static_cast<std::uint64_t>(texture.magnify) << 32);
        for (GLenum mode : texture.generation) {
            mix(mode);
        }
        for (const Combine* combine : {&texture.combine_rgb, &texture.combine_alpha}) {
            mix(combine->function);
            mix(static_cast<std::uint64_t>(combine->scale));
            for (int i = 0; i < 3; ++i) {
                mix(combine->sources[i] ^ (static_cast<std::uint64_t>(combine->operands[i]) << 32));
            }
        }
    }
    return static_cast<std::size_t>(hash);
}

} // namespace legacygl
