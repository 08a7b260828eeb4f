#include "legacygl/backend/es3_backend.h"

#include "legacygl/backend/es3_functions.h"
#include "legacygl/backend/es3_shader.h"
#include "legacygl/backend/es3_target.h"

#include <cstdio>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace legacygl {
namespace {

struct Geometry
{
    GLuint vertex_array = 0;
    GLuint vertices = 0;
    GLuint indices = 0;
    VertexFormat format;
};

struct Program
{
    GLuint name = 0;
    std::array<GLint, UNIFORM_GROUP_COUNT> locations{};
    std::array<std::uint64_t, UNIFORM_GROUP_COUNT> revisions{}; ///< Of the values it holds.
};

GLenum draw_mode(PrimitiveClass primitive)
{
    switch (primitive) {
    case PrimitiveClass::points:
        return GL_POINTS;
    case PrimitiveClass::lines:
        return GL_LINES;
    default:
        return GL_TRIANGLES;
    }
}

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
        for (Geometry& geometry : geometries_)
            destroy(geometry);
        for (const Program& program : programs_)
            gl_.DeleteProgram(program.name);
        target_.destroy();
    }

    ProgramId create_program(const ProgramText& text) override
    {
        Program program;
        std::string message;
        program.name = link_program(gl_, text.vertex, text.fragment, message);
        if (program.name == 0)
            std::fprintf(stderr, "legacygl: a shader does not compile, please report this: %s\n%s\n%s\n",
                         message.c_str(), text.vertex.c_str(), text.fragment.c_str());
        for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i)
            program.locations[i] = gl_.GetUniformLocation(program.name, UNIFORM_GROUP_NAMES[i]);
        gl_.UseProgram(program.name);
        for (int unit = 0; unit < TEXTURE_UNIT_COUNT; ++unit)
            gl_.Uniform1i(gl_.GetUniformLocation(program.name, ("texture_" + std::to_string(unit)).c_str()),
                          unit);
        used_program_ = 0;
        ++counters.programs;
        return add(programs_, program);
    }

    GeometryId create_geometry(const VertexFormat& format, std::span<const float> vertices,
                               std::span<const std::uint32_t> indices) override
    {
        Geometry geometry = make_geometry(format, !indices.empty());
        upload(GL_ARRAY_BUFFER, vertices.size_bytes(), vertices.data(), GL_STATIC_DRAW);
        if (!indices.empty())
            upload(GL_ELEMENT_ARRAY_BUFFER, indices.size_bytes(), indices.data(), GL_STATIC_DRAW);
        if (!free_geometries_.empty()) {
            const GeometryId id = free_geometries_.back();
            free_geometries_.pop_back();
            geometries_[id] = geometry;
            return id;
        }
        return add(geometries_, geometry);
    }

    void destroy_geometry(GeometryId id) override
    {
        destroy(geometries_[id]);
        free_geometries_.push_back(id);
    }

    TextureId create_texture() override
    {
        GLuint name = 0;
        gl_.GenTextures(1, &name);
        return name;
    }

    void destroy_texture(TextureId id) override
    {
        gl_.DeleteTextures(1, &id);
        for (TextureId& bound : bound_textures_)
            if (bound == id)
                bound = 0;
    }

    void texture_image(TextureId id, int level, int width, int height,
                       std::span<const std::uint8_t> rgba) override
    {
        bind_texture(id);
        gl_.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       rgba.data());
        ++counters.uploads;
        counters.upload_bytes += rgba.size();
    }

    void generate_mipmap(TextureId id) override
    {
        bind_texture(id);
        gl_.GenerateMipmap(GL_TEXTURE_2D);
    }

    void sampling(TextureId id, const Sampling& sampling) override
    {
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
        const Geometry& geometry = geometries_[id];
        if (!apply(state, geometry.format))
            return;
        bind_vertex_array(geometry.vertex_array);
        draw_runs(runs);
    }

    void draw_stream(const DrawState& state, const VertexFormat& format, std::span<const float> vertices,
                     std::span<const std::uint32_t> indices, std::span<const DrawRun> runs) override
    {
        if (!apply(state, format))
            return;
        Geometry& geometry = stream_geometry(format);
        bind_vertex_array(geometry.vertex_array);
        gl_.BindBuffer(GL_ARRAY_BUFFER, geometry.vertices);
        upload(GL_ARRAY_BUFFER, vertices.size_bytes(), vertices.data(), GL_STREAM_DRAW);
        if (!indices.empty())
            upload(GL_ELEMENT_ARRAY_BUFFER, indices.size_bytes(), indices.data(), GL_STREAM_DRAW);
        draw_runs(runs);
    }

    void clear(const Pipeline& pipeline, const Clear& clear) override
    {
        apply(pipeline);
        gl_.ClearColor(clear.color.r, clear.color.g, clear.color.b, clear.color.a);
        gl_.ClearDepthf(clear.depth);
        gl_.ClearStencil(clear.stencil);
        gl_.Clear(clear.buffers);
    }

    void read_pixels(bool front, int x, int y, int width, int height, std::span<std::uint8_t> rgba) override
    {
        target_.read_from(front);
        gl_.ReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    }

    void flush(bool wait) override { wait ? gl_.Finish() : gl_.Flush(); }

    void resize(int width, int height) override
    {
        target_.resize(width, height);
        forget_state();
    }

    void present() override
    {
        target_.present();
        forget_state();
    }

    void show_front() override
    {
        target_.show_front();
        forget_state();
    }

    void context_lost() override
    {
        ++generation;
        programs_.resize(1);
        geometries_.resize(1);
        free_geometries_.clear();
        streams_.clear();
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
        forget_state();
    }

    void forget_state()
    {
        pipeline_.reset();
        used_program_ = 0;
        bound_textures_ = {};
        active_unit_ = -1;
        bound_vertex_array_ = 0;
        constants_ = {};
    }

    void upload(GLenum target, std::size_t bytes, const void* data, GLenum usage)
    {
        gl_.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
        ++counters.uploads;
        counters.upload_bytes += bytes;
    }

    Geometry make_geometry(const VertexFormat& format, bool indexed)
    {
        Geometry geometry;
        geometry.format = format;
        gl_.GenVertexArrays(1, &geometry.vertex_array);
        bind_vertex_array(geometry.vertex_array);
        gl_.GenBuffers(1, &geometry.vertices);
        gl_.BindBuffer(GL_ARRAY_BUFFER, geometry.vertices);
        std::size_t offset = 0;
        for (int i = 0; i < ATTRIBUTE_COUNT; ++i) {
            if (format.components[i] == 0)
                continue;
            gl_.EnableVertexAttribArray(i);
            gl_.VertexAttribPointer(i, format.components[i], GL_FLOAT, GL_FALSE,
                                    static_cast<GLsizei>(format.floats() * sizeof(float)),
                                    reinterpret_cast<const void*>(offset));
            offset += format.components[i] * sizeof(float);
        }
        if (indexed) {
            gl_.GenBuffers(1, &geometry.indices);
            gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, geometry.indices);
        }
        return geometry;
    }

    /// The vertex array for streamed vertices of a format; one a format, made at its first use.
    Geometry& stream_geometry(const VertexFormat& format)
    {
        std::uint64_t key = 0;
        for (std::uint8_t components : format.components)
            key = key * 5 + components;
        const auto found = streams_.find(key);
        if (found != streams_.end())
            return geometries_[found->second];
        const GeometryId id = add(geometries_, make_geometry(format, true));
        streams_[key] = id;
        return geometries_[id];
    }

    void destroy(Geometry& geometry)
    {
        if (geometry.vertex_array == 0)
            return;
        if (bound_vertex_array_ == geometry.vertex_array)
            bound_vertex_array_ = 0;
        gl_.DeleteVertexArrays(1, &geometry.vertex_array);
        gl_.DeleteBuffers(1, &geometry.vertices);
        gl_.DeleteBuffers(1, &geometry.indices);
        geometry = Geometry{};
    }

    void bind_vertex_array(GLuint name)
    {
        if (bound_vertex_array_ != name)
            gl_.BindVertexArray(name);
        bound_vertex_array_ = name;
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
        for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i) {
            const UniformValues& values = state.uniforms[i];
            if (program.locations[i] < 0 || program.revisions[i] == values.revision)
                continue;
            program.revisions[i] = values.revision;
            gl_.Uniform4fv(program.locations[i], static_cast<GLsizei>(values.values.size()),
                           &values.values.front().x);
            ++counters.uniform_uploads;
        }
        for (int unit = TEXTURE_UNIT_COUNT; unit-- > 0;)
            if (state.textures[unit] != 0)
                bind_texture(state.textures[unit], unit);
        apply(state.pipeline);
        apply_constants(state, format);
        return program.name != 0;
    }

    void draw_runs(std::span<const DrawRun> runs)
    {
        for (const DrawRun& run : runs) {
            const auto count = static_cast<GLsizei>(run.count);
            if (run.indexed)
                gl_.DrawElements(draw_mode(run.primitive), count, GL_UNSIGNED_INT,
                                 reinterpret_cast<const void*>(run.first * sizeof(std::uint32_t)));
            else
                gl_.DrawArrays(draw_mode(run.primitive), static_cast<GLint>(run.first), count);
            ++counters.draw_calls;
            counters.vertices += run.count;
        }
    }

    const Es3Functions gl_;
    Es3Target target_;
    std::vector<Geometry> geometries_{1};
    std::vector<GeometryId> free_geometries_;
    std::vector<Program> programs_{1};
    std::unordered_map<std::uint64_t, GeometryId> streams_;

    bool lost_ = false;
    std::optional<Pipeline> pipeline_; ///< What ES has now; empty when that is not known.
    std::array<std::optional<glm::vec4>, ATTRIBUTE_COUNT> constants_;
    GLuint used_program_ = 0;
    std::array<TextureId, TEXTURE_UNIT_COUNT> bound_textures_{};
    int active_unit_ = -1; ///< -1: not known.
    GLuint bound_vertex_array_ = 0;
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
