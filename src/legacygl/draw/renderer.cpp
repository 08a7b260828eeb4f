#include "legacygl/draw/renderer.h"

#include "legacygl/draw/es_limits.h"
#include "legacygl/draw/quad_order.h"
#include "legacygl/shader/shader_text.h"
#include "legacygl/shader/shader_values.h"

#include <algorithm>
#include <utility>

namespace legacygl {
namespace {

bool has_derived_levels(const Texture& texture)
{
    return std::any_of(texture.levels.begin(), texture.levels.end(),
                       [](const TextureImage& image) { return image.derived; });
}

/// Returns whether primitives of the class are polygons covered by a stipple.
bool stipples(const State& state, PrimitiveClass primitive)
{
    return primitive == PrimitiveClass::triangles && state.raster.polygon_stipple.enabled;
}

/// Returns whether flat shading takes a colour from one vertex that others may not have.
bool takes_vertex_color(const State& state, std::uint32_t varying)
{
    return state.lighting.shade_model == GL_FLAT &&
           (state.lighting.enabled || (varying & bit_of(Attribute::color)));
}

/// Returns whether the key has those texture coordinates constant that do not vary.
bool same_constants(const ShaderKey& key, std::uint32_t varying)
{
    for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
        if (key.textures[unit].constant != key.textures[unit].takes_one_coordinate(unit, varying)) {
            return false;
        }
    }
    return true;
}

/// Returns whether a vertex of the batch has a material of its own that shines.
bool shines(const VertexBatch& batch)
{
    const auto sets_shininess = [](const MaterialChange& change) {
        return change.name == GL_SHININESS && change.values[0] != 0;
    };
    return batch.changes_materials &&
           (batch.materials_before[0].shininess != 0 || batch.materials_before[1].shininess != 0 ||
            std::any_of(batch.material_changes.begin(), batch.material_changes.end(), sets_shininess));
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
    p.blend.enabled = p.blend.enabled && !state.fragment.color_logic_op;
    if (p.blend.weighs_by_both_constants()) {
        p.blend.source_rgb = GL_ONE;
    }
    p.polygon_offset = state.raster.polygon_offset_fill;
    p.polygon_offset_factor_units = {state.raster.polygon_offset_factor, state.raster.polygon_offset_units};
    if (state.fragment.draw_buffer == GL_NONE) {
        p.color_mask = {};
    } else {
        p.color_mask = state.fragment.color_mask;
    }
    p.draws_front = state.fragment.draws_front();
    p.draws_back = state.fragment.draws_back();
    p.dither = state.fragment.dither;
    p.line_width = state.raster.line_width;
    return p;
}

const ShaderKey& Renderer::key_for(const State& state, PrimitiveClass primitive, std::uint32_t varying)
{
    const bool same_kind = key_ && !key_->shaded && key_->points == (primitive == PrimitiveClass::points) &&
                           key_->polygon_stipple == stipples(state, primitive) &&
                           key_->flat == takes_one_color(state, varying) && same_constants(*key_, varying);
    if (same_kind && !(changed_ & ~change::matrices) && (!changed_ || keeps_length(state) == keeps_length_)) {
        return *key_;
    }
    keeps_length_ = keeps_length(state);
    return use(make_shader_key(state, primitive, varying));
}

const ShaderKey& Renderer::use(const ShaderKey& key)
{
    if (!key_ || !(key == *key_)) {
        key_ = key;
        layout_ = TransformLayout(key);
        changed_ |= change::everything; // The uniform arrays have another layout.
        draw_state_.program = 0;
    }
    return *key_;
}

std::uint32_t Renderer::attributes_read(const State& state)
{
    const bool known = !(changed_ & ~change::matrices) && key_ && !key_->shaded;
    const std::uint32_t read =
        legacygl::attributes_read(known ? *key_ : make_shader_key(state, PrimitiveClass::triangles, ~0u));
    return state.raster.unfilled() ? read | 1u << index_of(Attribute::edge_flag) : read;
}

ProgramId Renderer::program(const ShaderKey& key)
{
    ProgramId& id = programs_[key];
    if (id == 0) {
        id = backend_.create_program(make_program_text(key));
    }
    return id;
}

/// Brings the backend's texture up to date.
TextureId Renderer::texture(Texture& texture)
{
    const bool made = !texture.object.valid();
    if (made) {
        texture.object.set(backend_, backend_.create_texture());
    }
    const TextureId id = texture.object.id();
    const bool derives = texture.levels_to_derive || (made && has_derived_levels(texture));
    const auto upload = [&](std::size_t level, bool anyway) {
        TextureImage& image = texture.levels[level];
        if ((anyway || image.changed) && !image.derived && image.width > 0 && image.height > 0) {
            backend_.texture_image(id, static_cast<int>(level), image.width, image.height, image.rgba);
        }
        image.changed = false;
    };
    for (std::size_t level = 0; level < texture.levels.size(); ++level) {
        upload(level, made);
    }
    if (derives) {
        backend_.sampling(id, texture.parameters.sampling); // Levels are derived from the base level on.
        backend_.generate_mipmap(id);
        texture.levels_to_derive = false;
        for (auto level = static_cast<std::size_t>(texture.parameters.sampling.base_level) + 1;
             level < texture.levels.size(); ++level) {
            upload(level, true); // What was given after all.
        }
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

const DrawState& Renderer::prepare(const State& state, const ShaderKey& key)
{
    if (!changed_) {
        draw_state_.constants = &state.current;
        return draw_state_;
    }
    if (draw_state_.program == 0) {
        draw_state_.program = program(key);
    }
    if (changed_ & (change::matrices | change::lighting)) {
        refill(UniformGroup::transform, layout_.size,
               [&](std::span<glm::vec4> out) { fill_transform(state, key, layout_, out); });
    }
    if (key.lighting && (changed_ & change::lighting)) {
        refill(UniformGroup::lighting, lighting_layout::size(key.light_count),
               [&](std::span<glm::vec4> out) { fill_lighting(state.lighting, key, out); });
    }
    if (key.textured() && (changed_ & change::texturing)) {
        refill(UniformGroup::texturing, texturing_layout::SIZE,
               [&](std::span<glm::vec4> out) { fill_texturing(state, out); });
    }
    if (key.reads_fragments() && (changed_ & change::fragments)) {
        refill(UniformGroup::fragments, fragments_layout::size(key.polygon_stipple),
               [&](std::span<glm::vec4> out) { fill_fragments(state, target_copy_origin_, out); });
    }
    if (changed_ & change::texturing) {
        for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit) {
            Texture* used = state.texturing.used(state.texturing.units[unit]);
            draw_state_.textures[unit] = used ? texture(*used) : 0;
        }
    }
    if (changed_ & change::pipeline) {
        draw_state_.pipeline = make_pipeline(state);
    }
    if (changed_ & ~change::matrices) {
        ++draw_state_.revision;
    }
    draw_state_.constants = &state.current;
    changed_ = 0;
    return draw_state_;
}

/// Calls draw for each stretch of runs that one program draws: points need their own, and so may polygons.
template <class Draw>
void Renderer::for_each_program(const State& state, std::uint32_t varying, std::span<const DrawRun> runs,
                                Draw draw)
{
    const auto kind = [&](const DrawRun& run) {
        return std::pair(run.primitive == PrimitiveClass::points, stipples(state, run.primitive));
    };
    while (!runs.empty()) {
        const auto end = std::find_if(runs.begin(), runs.end(),
                                      [&](const DrawRun& run) { return kind(run) != kind(runs.front()); });
        const auto count = static_cast<std::size_t>(end - runs.begin());
        draw(prepare(state, key_for(state, runs.front().primitive, varying)), runs.first(count));
        runs = runs.subspan(count);
    }
}

void Renderer::draw(const State& state, const VertexBatch& batch)
{
    if (const std::optional<RasterWork> work = raster_work(state, backend_, batch, batch)) {
        return draw_shaded(state, batch, *work, false);
    }
    const std::span<const Primitive> primitives = batch.primitives;
    draw_batch(state, batch, primitives.first(batch.primitives_of_one_color()), batch.varying(true));
    draw_batch(state, batch, primitives.subspan(batch.primitives_of_one_color()), batch.varying(false));
}

void Renderer::draw_batch(const State& state, const VertexBatch& batch, std::span<const Primitive> primitives,
                          std::uint32_t varying)
{
    if (primitives.empty()) {
        return;
    }
    runs_.clear();
    indices_.clear();
    MesaQuadOrders quad_orders(state, batch, primitives, takes_vertex_color(state, varying), false);
    make_runs(primitives, runs_, indices_, &quad_orders);
    for_each_program(state, varying, runs_, [&](const DrawState& draw_state, std::span<const DrawRun> runs) {
        backend_.draw_stream(draw_state, batch.format, batch.used_vertices(), indices_, runs);
    });
}

void Renderer::draw(const State& state, ListGeometry& geometry)
{
    const ListGeometry::Vertices& vertices = *geometry.vertices;
    if (const std::optional<RasterWork> work =
            raster_work(state, backend_, geometry.traits, vertices.batch)) {
        return draw_shaded(state, vertices.batch, *work, true);
    }
    if (!geometry.object.valid()) {
        geometry.object.set(backend_,
                            backend_.create_geometry(geometry.traits.format, vertices.batch.used_vertices(),
                                                     vertices.indices));
    }
    const auto draw = [&](const DrawState& draw_state, std::span<const DrawRun> runs) {
        if (!backend_.draw(draw_state, geometry.object.id(), runs)) {
            backend_.draw_stream(draw_state, geometry.traits.format, vertices.batch.used_vertices(),
                                 vertices.indices, runs);
        }
    };
    const std::span<const DrawRun> runs = geometry.runs();
    for_each_program(state, geometry.traits.varying(true), runs.first(geometry.runs_of_one_color), draw);
    for_each_program(state, geometry.traits.varying(false), runs.subspan(geometry.runs_of_one_color), draw);
}

void Renderer::draw_shaded(const State& state, const VertexBatch& batch, const RasterWork& work, bool in_list)
{
    const std::span<const Primitive> primitives = batch.primitives;
    draw_shaded(state, batch, primitives.first(batch.primitives_of_one_color()), batch.varying(true), work,
                in_list);
    draw_shaded(state, batch, primitives.subspan(batch.primitives_of_one_color()), batch.varying(false), work,
                in_list);
}

void Renderer::draw_shaded(const State& state, const VertexBatch& batch,
                           std::span<const Primitive> primitives, std::uint32_t varying,
                           const RasterWork& work, bool in_list)
{
    if (primitives.empty()) {
        return;
    }
    ShaderKey key = make_shader_key(state, PrimitiveClass::triangles, varying);
    key.specular = key.specular || shines(batch);
    VertexShading shading(state, key);
    const std::vector<ShadedVertex> vertices = shading.shade(batch);
    RasterOutput output(key, shading.viewport(), state.raster.line_width / 2,
                        state.fragment.effective_logic_op() != GL_COPY);
    PrimitivePipeline stages(state, key, work, shading, stipple_counter_, output);
    MesaQuadOrders quad_orders(state, batch, primitives, takes_vertex_color(state, varying), in_list);
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        const Primitive& primitive = primitives[p];
        stages.draw(primitive.mode, quad_orders.of(p),
                    std::span(vertices).subspan(primitive.first, primitive.count));
    }
    draw_shaded(state, key, work, output);
}

void Renderer::draw_shaded(const State& state, const ShaderKey& shading, const RasterWork& work,
                           const RasterOutput& output)
{
    for (const ShadedDraw& draw : output.draws()) {
        if (state.fragment.effective_logic_op() != GL_COPY && !copy_target(state, draw.box)) {
            continue;
        }
        draw_shaded(state, shading, work, output, draw);
        draw_state_.textures[TARGET_COPY_SAMPLER] = 0;
    }
}

/// Copies what a logic op combines a draw's fragments with. Returns false when all of it is out of sight.
bool Renderer::copy_target(const State& state, const PixelBox& box)
{
    constexpr int MARGIN = VIEWPORT_MARGIN;
    const std::array<GLint, 4>& v = state.transform.viewport;
    const PixelBox seen = box.within(
        {std::max(0, v[0] - MARGIN), std::max(0, v[1] - MARGIN), v[0] + v[2] + MARGIN, v[1] + v[3] + MARGIN});
    if (seen.empty()) {
        return false;
    }
    draw_state_.textures[TARGET_COPY_SAMPLER] =
        target_copy_.read(backend_, state.fragment.draws_front() && !state.fragment.draws_back(), seen);
    target_copy_origin_ = {seen.x0, seen.y0, 0, 0};
    changed_ |= change::fragments;
    return true;
}

void Renderer::draw_shaded(const State& state, const ShaderKey& shading, const RasterWork& work,
                           const RasterOutput& output, const ShadedDraw& draw)
{
    const bool stipple = draw.polygons && state.raster.polygon_stipple.enabled;
    prepare(state, use(make_shaded_key(shading, draw.primitive, draw.coverage, stipple,
                                       state.fragment.effective_logic_op())));
    ++draw_state_.revision;
    Pipeline& fixed = draw_state_.pipeline;
    fixed = make_pipeline(state);
    if (work.unfilled || !draw.polygons) {
        fixed.cull_face = fixed.polygon_offset = false;
    }
    for (std::size_t i = 0; draw.grown && i < 2; ++i) {
        fixed.viewport[i] -= VIEWPORT_MARGIN;
        fixed.viewport[i + 2] += 2 * VIEWPORT_MARGIN;
    }
    const auto floats = static_cast<std::size_t>(output.format().floats());
    const DrawRun run{draw.primitive, false, 0, draw.count};
    backend_.draw_stream(draw_state_, output.format(),
                         std::span(output.vertices()).subspan(draw.first * floats, draw.count * floats), {},
                         {&run, 1});
    changed_ |= change::pipeline; // The next draw wants its own.
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
    changed_ = change::everything;
}

} // namespace legacygl
