#include "legacygl/renderer.h"

#include "legacygl/shader_text.h"
#include "legacygl/shader_values.h"

#include <algorithm>

namespace legacygl {
namespace {

bool has_derived_levels(const Texture& texture)
{
    return std::any_of(texture.levels.begin(), texture.levels.end(),
                       [](const TextureImage& image) { return image.derived; });
}

} // namespace

Pipeline make_pipeline(const State& state)
{
    Pipeline p;
    p.viewport = state.transform.viewport;
    p.depth_range = state.transform.depth_range;
    p.depth_test = state.fragment.depth_test;
    p.depth_mask = state.fragment.depth_mask;
    p.depth_func = state.fragment.depth_func;
    p.cull_face = state.raster.cull_face;
    p.cull_face_mode = state.raster.cull_face_mode;
    p.front_face = state.raster.front_face;
    p.scissor_test = state.fragment.scissor_test;
    p.scissor_box = state.fragment.scissor_box;
    p.stencil = state.fragment.stencil;
    p.blend = state.fragment.blend;
    p.polygon_offset = state.raster.polygon_offset_fill;
    p.polygon_offset_factor_units = {state.raster.polygon_offset_factor, state.raster.polygon_offset_units};
    if (state.fragment.draw_buffer == GL_NONE)
        p.color_mask = {};
    else
        p.color_mask = state.fragment.color_mask;
    p.draws_front = state.fragment.draws_front();
    p.draws_back = state.fragment.draws_back();
    p.dither = state.fragment.dither;
    p.line_width = state.raster.line_width;
    return p;
}

const ShaderKey& Renderer::key_for(const State& state, PrimitiveClass primitive)
{
    const bool points = primitive == PrimitiveClass::points;
    if (!changed_ && key_ && key_->points == points)
        return *key_;
    const ShaderKey key = make_shader_key(state, primitive);
    if (!key_ || !(key == *key_)) {
        key_ = key;
        changed_ |= everything; // The uniform arrays are laid out anew.
        draw_state_.program = 0;
    }
    return *key_;
}

std::uint32_t Renderer::attributes_read(const State& state)
{
    const PrimitiveClass same = key_ && key_->points ? PrimitiveClass::points : PrimitiveClass::triangles;
    return legacygl::attributes_read(key_for(state, same));
}

ProgramId Renderer::program(const ShaderKey& key)
{
    ProgramId& id = programs_[key];
    if (id == 0)
        id = backend_.create_program(make_program_text(key));
    return id;
}

/// Brings the backend's texture up to date.
TextureId Renderer::texture(Texture& texture)
{
    const bool made = !texture.object.valid();
    if (made)
        texture.object.set(backend_, backend_.create_texture());
    const TextureId id = texture.object.id();
    const bool derives = texture.levels_to_derive || (made && has_derived_levels(texture));
    const auto upload = [&](std::size_t level, bool anyway) {
        TextureImage& image = texture.levels[level];
        if ((anyway || image.changed) && !image.derived && image.width > 0 && image.height > 0)
            backend_.texture_image(id, static_cast<int>(level), image.width, image.height, image.rgba);
        image.changed = false;
    };
    for (std::size_t level = 0; level < texture.levels.size(); ++level)
        upload(level, made);
    if (derives) {
        backend_.sampling(id, texture.parameters.sampling); // Levels are derived from the base level on.
        backend_.generate_mipmap(id);
        texture.levels_to_derive = false;
        for (auto level = static_cast<std::size_t>(texture.parameters.sampling.base_level) + 1;
             level < texture.levels.size(); ++level)
            upload(level, true); // What was given after all.
    }
    if (made || texture.sampling_changed) {
        backend_.sampling(id, texture.parameters.sampling);
        texture.sampling_changed = false;
    }
    return id;
}

template <class Fill> void Renderer::refill(UniformGroup which, int size, Fill fill)
{
    Group& group = groups_[static_cast<int>(which)];
    group.values.resize(size);
    fill(std::span<glm::vec4>(group.values));
    ++group.revision;
    draw_state_.uniforms[static_cast<int>(which)] = {group.values, group.revision};
}

const DrawState& Renderer::prepare(const State& state, PrimitiveClass primitive)
{
    const ShaderKey& key = key_for(state, primitive);
    if (!changed_) {
        draw_state_.constants = &state.current;
        return draw_state_;
    }
    if (draw_state_.program == 0)
        draw_state_.program = program(key);
    if (changed_ & (matrices | lighting))
        refill(UniformGroup::transform, TransformLayout(key).size,
               [&](std::span<glm::vec4> out) { fill_transform(state, key, out); });
    if (key.lighting && (changed_ & lighting))
        refill(UniformGroup::lighting, lighting_layout::size(key.light_count),
               [&](std::span<glm::vec4> out) { fill_lighting(state, key, out); });
    if (key.textured() && (changed_ & (texturing | matrices)))
        refill(UniformGroup::texturing, texturing_layout::SIZE,
               [&](std::span<glm::vec4> out) { fill_texturing(state, out); });
    if ((key.fog_mode || key.alpha_func != GL_ALWAYS) && (changed_ & fragments))
        refill(UniformGroup::fragments, fragments_layout::SIZE,
               [&](std::span<glm::vec4> out) { fill_fragments(state, out); });
    if (changed_ & texturing)
        for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
            Texture* used = state.texturing.used(state.texturing.units[unit]);
            draw_state_.textures[unit] = used ? texture(*used) : 0;
        }
    if (changed_ & pipeline)
        draw_state_.pipeline = make_pipeline(state);
    draw_state_.constants = &state.current;
    changed_ = 0;
    return draw_state_;
}

/// Calls draw for each stretch of runs of one class: points need a program of their own.
template <class Draw> void Renderer::for_each_class(std::span<const DrawRun> runs, Draw draw)
{
    while (!runs.empty()) {
        const bool points = runs.front().primitive == PrimitiveClass::points;
        const auto end = std::find_if(runs.begin(), runs.end(), [points](const DrawRun& run) {
            return (run.primitive == PrimitiveClass::points) != points;
        });
        const auto count = static_cast<std::size_t>(end - runs.begin());
        draw(runs.first(count));
        runs = runs.subspan(count);
    }
}

void Renderer::draw(const State& state, const VertexBatch& batch)
{
    runs_.clear();
    indices_.clear();
    make_runs(batch.primitives, runs_, indices_);
    for_each_class(runs_, [&](std::span<const DrawRun> runs) {
        backend_.draw_stream(prepare(state, runs.front().primitive), batch.format, batch.used_vertices(),
                             indices_, runs);
    });
}

void Renderer::draw(const State& state, ListGeometry& geometry)
{
    if (!geometry.object.valid())
        geometry.object.set(backend_,
                            backend_.create_geometry(geometry.batch.format, geometry.batch.used_vertices(),
                                                     geometry.indices));
    for_each_class(geometry.runs, [&](std::span<const DrawRun> runs) {
        backend_.draw(prepare(state, runs.front().primitive), geometry.object.id(), runs);
    });
}

void Renderer::clear(const State& state, GLbitfield buffers)
{
    const FragmentState& fragment = state.fragment;
    backend_.clear(
        make_pipeline(state),
        {buffers, fragment.clear_color, static_cast<GLfloat>(fragment.clear_depth), fragment.clear_stencil});
}

void Renderer::forget_objects()
{
    programs_.clear();
    key_.reset();
    draw_state_ = {};
    changed_ = everything;
}

} // namespace legacygl
