#include "legacygl/backend/es3_backend.h"

#include "legacygl/backend/es3_functions.h"
#include "legacygl/backend/es3_geometry.h"
#include "legacygl/backend/es3_shader.h"
#include "legacygl/backend/es3_stream.h"
#include "legacygl/backend/es3_target.h"

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace legacygl {
namespace {

struct Program
{
    GLuint name = 0;
    std::array<GLint, UNIFORM_GROUP_COUNT> locations{};
    std::array<std::uint64_t, UNIFORM_GROUP_COUNT> revisions{}; ///< Of the values it holds.
};

constexpr int TRANSFORM = static_cast<int>(UniformGroup::transform);

/// Index 0 stays empty, so that 0 can mean none.
template <class T> std::uint32_t add(std::vector<T>& objects, const T& object)
{
    objects.push_back(object);
    return static_cast<std::uint32_t>(objects.size() - 1);
}

class Es3Backend final : public Backend
{
public:
    Es3Backend(const Es3Functions& functions, int width, int height, LegacyGLTarget target)
        : gl_(functions), target_(gl_, target, width, height)
    {
        gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &maximum_texture_size);
        restore_state();
    }

    ~Es3Backend() override
    {
        geometries_.clear();
        for (const Program& program : programs_)
            gl_.DeleteProgram(program.name);
        target_.destroy();
    }

    ProgramId create_program(const ProgramText& text) override
    {
        draw_gathered();
        Program program;
        std::string message;
        program.name = link_program(gl_, text.vertex, text.fragment, message);
        if (program.name == 0)
            std::fprintf(stderr, "legacygl: a shader does not compile, please report this: %s\n%s\n%s\n",
                         message.c_str(), text.vertex.c_str(), text.fragment.c_str());
        for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i)
            program.locations[i] = gl_.GetUniformLocation(program.name, UNIFORM_GROUP_NAMES[i]);
        gl_.UseProgram(program.name);
        for (int unit = 0; unit < SAMPLER_COUNT; ++unit)
            gl_.Uniform1i(gl_.GetUniformLocation(program.name, ("texture_" + std::to_string(unit)).c_str()),
                          unit);
        used_program_ = 0;
        ++counters.programs;
        return add(programs_, program);
    }

    GeometryId create_geometry(const VertexFormat& format, std::span<const float> vertices,
                               std::span<const std::uint32_t> indices) override
    {
        return geometries_.create(format, vertices, indices);
    }

    void destroy_geometry(GeometryId id) override { geometries_.destroy(id); }

    TextureId create_texture() override
    {
        GLuint name = 0;
        gl_.GenTextures(1, &name);
        return name;
    }

    void destroy_texture(TextureId id) override
    {
        draw_gathered();
        gl_.DeleteTextures(1, &id);
        for (TextureId& bound : bound_textures_)
            if (bound == id)
                bound = 0;
    }

    void texture_image(TextureId id, int level, int width, int height,
                       std::span<const std::uint8_t> rgba) override
    {
        draw_gathered();
        bind_texture(id);
        gl_.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       rgba.data());
        ++counters.uploads;
        counters.upload_bytes += rgba.size();
    }

    void generate_mipmap(TextureId id) override
    {
        draw_gathered();
        bind_texture(id);
        gl_.GenerateMipmap(GL_TEXTURE_2D);
    }

    void sampling(TextureId id, const Sampling& sampling) override
    {
        draw_gathered();
        bind_texture(id);
        const auto set = [this](GLenum name, GLenum value) {
            gl_.TexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(value));
        };
        // ES has no borders: the shader mixes their colour in (shader_border_text.cpp).
        const auto wrap = [](GLenum mode) {
            return mode == GL_CLAMP || mode == GL_CLAMP_TO_BORDER ? GLenum{GL_CLAMP_TO_EDGE} : mode;
        };
        set(GL_TEXTURE_MIN_FILTER, sampling.minify);
        set(GL_TEXTURE_MAG_FILTER, sampling.magnify);
        set(GL_TEXTURE_WRAP_S, wrap(sampling.wrap_s));
        set(GL_TEXTURE_WRAP_T, wrap(sampling.wrap_t));
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, sampling.base_level);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, sampling.max_level);
        gl_.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, sampling.min_lod);
        gl_.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, sampling.max_lod);
    }

    void draw(const DrawState& state, GeometryId id, std::span<const DrawRun> runs) override
    {
        draw_gathered();
        if (apply(state, geometries_.format(id)))
            geometries_.draw(id, runs);
    }

    void draw_stream(const DrawState& state, const VertexFormat& format, std::span<const float> vertices,
                     std::span<const std::uint32_t> indices, std::span<const DrawRun> runs) override
    {
        if (gathered_.empty() || gathered_.full() || !only_transform_changes(state, format)) {
            draw_gathered();
            if (!apply(state, format))
                return;
            gathered_.format = format;
            gathered_program_ = state.program;
        }
        gathered_.add(state.uniforms[TRANSFORM], vertices, indices, runs);
    }

    void clear(const Pipeline& pipeline, const Clear& clear) override
    {
        draw_gathered();
        apply(pipeline);
        gl_.ClearColor(clear.color.r, clear.color.g, clear.color.b, clear.color.a);
        gl_.ClearDepthf(clear.depth);
        gl_.ClearStencil(clear.stencil);
        gl_.Clear(clear.buffers);
    }

    void read_pixels(bool front, int x, int y, int width, int height, std::span<std::uint8_t> rgba) override
    {
        draw_gathered();
        target_.read_from(front);
        gl_.ReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    }

    void flush(bool wait) override
    {
        draw_gathered();
        wait ? gl_.Finish() : gl_.Flush();
    }

    void resize(int width, int height) override
    {
        draw_gathered();
        target_.resize(width, height);
        forget_state();
    }

    void present() override
    {
        draw_gathered();
        target_.present();
        forget_state();
    }

    void show_front() override
    {
        draw_gathered();
        target_.show_front();
        forget_state();
    }

    void context_lost() override
    {
        ++generation;
        programs_.resize(1);
        geometries_.forget();
        gathered_.clear();
        target_.forget();
        lost_ = true;
    }

    void context_restored() override
    {
        lost_ = false;
        target_.restore();
        restore_state();
    }

private:
    void restore_state()
    {
        gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
        std::array<GLint, 2> line_widths{1, 1};
        gl_.GetIntegerv(GL_ALIASED_LINE_WIDTH_RANGE, line_widths.data());
        maximum_line_width = static_cast<float>(line_widths[1]);
        forget_state();
    }

    void forget_state()
    {
        pipeline_.reset();
        used_program_ = 0;
        bound_textures_ = {};
        active_unit_ = -1;
        geometries_.forget_binding();
        constants_ = {};
    }

    /// Whether the draw differs from those gathered in its vertices and its transform alone.
    bool only_transform_changes(const DrawState& state, const VertexFormat& format) const
    {
        if (state.program != gathered_program_ || format != gathered_.format ||
            !(state.pipeline == *pipeline_))
            return false;
        const Program& program = programs_[state.program];
        for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i)
            if (i != TRANSFORM && program.locations[i] >= 0 &&
                program.revisions[i] != state.uniforms[i].revision)
                return false;
        for (int unit = 0; unit < SAMPLER_COUNT; ++unit)
            if (state.textures[unit] != 0 && state.textures[unit] != bound_textures_[unit])
                return false;
        for (int i = 1; i < ATTRIBUTE_COUNT; ++i)
            if (format.components[i] == 0 && constants_[i] != (*state.constants)[i])
                return false;
        return true;
    }

    /// Draws what waits for its upload; everything that looks at the picture or changes what is used does so
    /// first.
    void draw_gathered()
    {
        if (gathered_.empty())
            return;
        geometries_.bind_stream(gathered_.format, gathered_.vertices, gathered_.indices);
        Program& program = programs_[gathered_program_];
        for (const Es3Stream::Draw& draw : gathered_.draws) {
            upload(program, TRANSFORM,
                   {std::span(gathered_.transforms).subspan(draw.first_value, draw.values), draw.revision});
            geometries_.draw_runs(std::span(gathered_.runs).subspan(draw.first_run, draw.runs),
                                  draw.first_vertex, draw.first_index);
        }
        gathered_.clear();
    }

    /// Uploads a group's values unless the program, which is in use, has them.
    void upload(Program& program, int group, const UniformValues& values)
    {
        if (program.locations[group] < 0 || program.revisions[group] == values.revision)
            return;
        program.revisions[group] = values.revision;
        gl_.Uniform4fv(program.locations[group], static_cast<GLsizei>(values.values.size()),
                       &values.values.front().x);
        ++counters.uniform_uploads;
    }

    /// Binds the texture to the unit, which is then the active one if anything had to be done.
    void bind_texture(TextureId id, int unit = 0)
    {
        if (bound_textures_[unit] == id && (active_unit_ == unit))
            return;
        if (active_unit_ != unit)
            gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        active_unit_ = unit;
        if (bound_textures_[unit] != id)
            gl_.BindTexture(GL_TEXTURE_2D, id);
        bound_textures_[unit] = id;
    }

    void set_enabled(GLenum capability, bool enabled)
    {
        enabled ? gl_.Enable(capability) : gl_.Disable(capability);
    }

    void apply(const StencilState& s)
    {
        set_enabled(GL_STENCIL_TEST, s.enabled);
        gl_.StencilFunc(s.func, s.reference, s.value_mask);
        gl_.StencilOp(s.fail, s.depth_fail, s.depth_pass);
        gl_.StencilMask(s.write_mask);
    }

    void apply(const BlendState& b)
    {
        set_enabled(GL_BLEND, b.enabled);
        gl_.BlendFuncSeparate(b.source_rgb, b.destination_rgb, b.source_alpha, b.destination_alpha);
        gl_.BlendEquation(b.equation);
        gl_.BlendColor(b.color.r, b.color.g, b.color.b, b.color.a);
    }

    void apply(const Pipeline& p)
    {
        if (pipeline_ && *pipeline_ == p)
            return;
        const bool all = !pipeline_;
        const Pipeline& old = all ? p : *pipeline_;
        if (all || old.draws_front != p.draws_front || old.draws_back != p.draws_back)
            target_.draw_into(p.draws_front, p.draws_back);
        if (all || old.viewport != p.viewport)
            gl_.Viewport(p.viewport[0], p.viewport[1], p.viewport[2], p.viewport[3]);
        if (all || old.depth_range != p.depth_range)
            gl_.DepthRangef(p.depth_range[0], p.depth_range[1]);
        if (all || old.depth_test != p.depth_test)
            set_enabled(GL_DEPTH_TEST, p.depth_test);
        if (all || old.depth_mask != p.depth_mask)
            gl_.DepthMask(p.depth_mask);
        if (all || old.depth_func != p.depth_func)
            gl_.DepthFunc(p.depth_func);
        if (all || old.cull_face != p.cull_face)
            set_enabled(GL_CULL_FACE, p.cull_face);
        if (all || old.cull_face_mode != p.cull_face_mode)
            gl_.CullFace(p.cull_face_mode);
        if (all || old.front_face != p.front_face)
            gl_.FrontFace(p.front_face);
        if (all || old.scissor_test != p.scissor_test)
            set_enabled(GL_SCISSOR_TEST, p.scissor_test);
        if (all || old.scissor_box != p.scissor_box)
            gl_.Scissor(p.scissor_box[0], p.scissor_box[1], p.scissor_box[2], p.scissor_box[3]);
        if (all || !(old.stencil == p.stencil))
            apply(p.stencil);
        if (all || !(old.blend == p.blend))
            apply(p.blend);
        if (all || old.polygon_offset != p.polygon_offset)
            set_enabled(GL_POLYGON_OFFSET_FILL, p.polygon_offset);
        if (all || old.polygon_offset_factor_units != p.polygon_offset_factor_units)
            gl_.PolygonOffset(p.polygon_offset_factor_units[0], p.polygon_offset_factor_units[1]);
        if (all || old.color_mask != p.color_mask)
            gl_.ColorMask(p.color_mask[0], p.color_mask[1], p.color_mask[2], p.color_mask[3]);
        if (all || old.dither != p.dither)
            set_enabled(GL_DITHER, p.dither);
        if (all || old.line_width != p.line_width)
            gl_.LineWidth(p.line_width);
        pipeline_ = p;
    }

    void apply_constants(const DrawState& state, const VertexFormat& format)
    {
        for (int i = 1; i < ATTRIBUTE_COUNT; ++i) {
            const glm::vec4& value = (*state.constants)[i];
            if (format.components[i] != 0 || constants_[i] == value)
                continue;
            gl_.VertexAttrib4f(i, value.x, value.y, value.z, value.w);
            constants_[i] = value;
        }
    }

    bool apply(const DrawState& state, const VertexFormat& format)
    {
        if (lost_ || state.program == 0)
            return false;
        Program& program = programs_[state.program];
        if (used_program_ != program.name)
            gl_.UseProgram(program.name);
        used_program_ = program.name;
        for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i)
            upload(program, i, state.uniforms[i]);
        for (int unit = SAMPLER_COUNT; unit-- > 0;)
            if (state.textures[unit] != 0)
                bind_texture(state.textures[unit], unit);
        apply(state.pipeline);
        apply_constants(state, format);
        return program.name != 0;
    }

    const Es3Functions gl_;
    Es3Target target_;
    Es3Geometries geometries_{gl_, counters};
    Es3Stream gathered_;
    ProgramId gathered_program_ = 0;
    std::vector<Program> programs_{1};

    bool lost_ = false;
    std::optional<Pipeline> pipeline_; ///< What ES has now; empty when that is not known.
    std::array<std::optional<glm::vec4>, ATTRIBUTE_COUNT> constants_;
    GLuint used_program_ = 0;
    std::array<TextureId, SAMPLER_COUNT> bound_textures_{};
    int active_unit_ = -1; ///< -1: not known.
};

} // namespace

std::unique_ptr<Backend> make_es3_backend(LegacyGLLoader loader, int width, int height, LegacyGLTarget target,
                                          std::string& message)
{
    Es3Functions functions;
    const std::string missing = functions.load(loader);
    if (!missing.empty()) {
        message = "The OpenGL ES 3 function " + missing + " is missing.";
        return nullptr;
    }
    return std::make_unique<Es3Backend>(functions, width, height, target);
}

} // namespace legacygl
