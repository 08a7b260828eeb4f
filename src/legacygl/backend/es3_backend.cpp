#include "legacygl/backend/es3_backend.h"

#include "legacygl/backend/es3_batch.h"
#include "legacygl/backend/es3_depth_reader.h"
#include "legacygl/backend/es3_fixed_state.h"
#include "legacygl/backend/es3_functions.h"
#include "legacygl/backend/es3_geometry.h"
#include "legacygl/backend/es3_line_probe.h"
#include "legacygl/backend/es3_programs.h"
#include "legacygl/backend/es3_stream.h"
#include "legacygl/backend/es3_target.h"
#include "legacygl/backend/es3_textures.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace legacygl {
namespace {

constexpr std::uint32_t STREAM = 0; ///< No page.
constexpr int TRANSFORM = static_cast<int>(UniformGroup::transform);

class Es3Backend final : public Backend
{
public:
    Es3Backend(const Es3Functions& functions, int width, int height, LegacyGLTarget target)
        : gl_(functions), target_(gl_, fullscreen_pass_, target, width, height)
    {
        gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &maximum_texture_size);
        std::array<GLint, 2> viewport{};
        gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
        maximum_viewport_size = std::min(viewport[0], viewport[1]);
        restore_state();
    }

    ~Es3Backend() override
    {
        geometries_.clear();
        programs_.clear();
        target_.destroy();
        fullscreen_pass_.destroy();
    }

    ProgramId create_program(const ProgramText& text) override
    {
        draw_waiting();
        return programs_.create(text);
    }

    GeometryId create_geometry(const VertexFormat& format, std::span<const float> vertices,
                               std::span<const std::uint32_t> indices) override
    {
        return geometries_.create(format, vertices, indices);
    }

    void destroy_geometry(GeometryId id) override
    {
        draw_waiting();
        geometries_.destroy(id);
    }

    TextureId create_texture() override { return textures_.create(); }

    void destroy_texture(TextureId id) override
    {
        draw_waiting();
        textures_.destroy(id);
    }

    void texture_image(TextureId id, int level, int width, int height,
                       std::span<const std::uint8_t> rgba) override
    {
        draw_waiting();
        textures_.image(id, level, width, height, rgba);
    }

    void generate_mipmap(TextureId id) override
    {
        draw_waiting();
        textures_.generate_mipmap(id);
    }

    void sampling(TextureId id, const Sampling& sampling) override
    {
        draw_waiting();
        textures_.sampling(id, sampling);
    }

    bool draw(const DrawState& state, GeometryId id, std::span<const DrawRun> runs) override
    {
        Es3Geometries::Place& place = geometries_.place(id);
        const VertexFormat& format = geometries_.format(id);
        const UniformValues& transform = state.uniforms[TRANSFORM];
        const bool goes_on = only_transform_changes(state, format);
        const bool waits_in_stream = goes_on && waiting_page_ == STREAM;
        const bool waits_itself = goes_on && waiting_page_ == place.page && place.batch == batch_number_;
        if (!(goes_on && waiting_page_ == place.page && batch_.put(transform, place.slot))) {
            if (place.small && (waits_in_stream || waits_itself)) {
                return false;
            }
            if (!begin(state, format, place.page)) {
                return true;
            }
            batch_.put(transform, place.slot);
        }
        place.batch = batch_number_;
        batch_.add(runs, place.first_vertex, place.first_index);
        return true;
    }

    void draw_stream(const DrawState& state, const VertexFormat& format, std::span<const float> vertices,
                     std::span<const std::uint32_t> indices, std::span<const DrawRun> runs) override
    {
        const UniformValues& transform = state.uniforms[TRANSFORM];
        const bool goes_on =
            waiting_page_ == STREAM && !stream_.full() && only_transform_changes(state, format);
        if (!(goes_on && batch_.put(transform))) {
            if (!begin(state, format, STREAM)) {
                return;
            }
            stream_.begin(format);
            batch_.put(transform);
        }
        batch_.add(runs, stream_.first_vertex(), stream_.first_index());
        stream_.add(vertices, indices, batch_.slot());
    }

    void clear(const Pipeline& pipeline, const Clear& clear) override
    {
        draw_waiting();
        fixed_.apply(pipeline);
        gl_.ClearColor(clear.color.r, clear.color.g, clear.color.b, clear.color.a);
        gl_.ClearDepthf(clear.depth);
        gl_.ClearStencil(clear.stencil);
        gl_.Clear(clear.buffers);
    }

    void read_pixels(bool front, int x, int y, int width, int height, std::span<std::uint8_t> rgba) override
    {
        draw_waiting();
        target_.read_from(front);
        gl_.ReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    }

    bool read_depths(int x, int y, int width, int height, std::span<std::uint32_t> depths) override
    {
        begin_reading_depths();
        const bool done =
            depth_reader_.read_depths({target_width, target_height, x, y, width, height}, depths);
        forget_state();
        return done;
    }

    bool read_stencils(int x, int y, int width, int height, std::span<std::uint8_t> values) override
    {
        begin_reading_depths();
        const bool done =
            depth_reader_.read_stencils({target_width, target_height, x, y, width, height}, values);
        forget_state();
        return done;
    }

    bool clips_lines() override
    {
        if (lost_) {
            return true;
        }
        if (!clips_lines_) {
            draw_waiting();
            clips_lines_ = legacygl::clips_lines(gl_);
            forget_state();
        }
        return *clips_lines_;
    }

    void flush(bool wait) override
    {
        draw_waiting();
        wait ? gl_.Finish() : gl_.Flush();
    }

    void resize(int width, int height) override
    {
        draw_waiting();
        target_.resize(width, height);
        forget_state();
    }

    void present() override
    {
        draw_waiting();
        target_.present();
        forget_state();
    }

    void show_front() override
    {
        draw_waiting();
        target_.show_front();
        forget_state();
    }

    void context_lost() override
    {
        ++generation;
        programs_.forget();
        geometries_.forget();
        batch_.begin(1);
        target_.forget();
        fullscreen_pass_.forget();
        clips_lines_.reset();
        lost_ = true;
    }

    void context_restored() override
    {
        lost_ = false;
        target_.restore();
        restore_state();
    }

private:
    void begin_reading_depths()
    {
        draw_waiting();
        target_.read_from(false); // Front and back have one depth buffer.
    }

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
        fixed_.forget();
        programs_.forget_use();
        textures_.forget_binding();
        geometries_.forget_binding();
        constants_ = {};
    }

    /// Whether the draw differs from those that wait in its vertices and its transform alone.
    bool only_transform_changes(const DrawState& state, const VertexFormat& format) const
    {
        return !batch_.empty() && state.revision == waiting_revision_ && state.program == waiting_program_ &&
               format == waiting_format_ && has_constants(state, format);
    }

    /// Draws what waits and makes ready for draws of a page, or of the stream. Returns false when nothing can
    /// be drawn.
    bool begin(const DrawState& state, const VertexFormat& format, std::uint32_t page)
    {
        draw_waiting();
        if (!apply(state, format)) {
            return false;
        }
        waiting_page_ = page;
        waiting_format_ = format;
        waiting_program_ = state.program;
        waiting_revision_ = state.revision;
        batch_.begin(programs_[state.program].transform_slots);
        ++batch_number_;
        return true;
    }

    /// Calls what with each attribute that the program reads and the vertices lack.
    template <class What>
    static void for_each_constant(const Es3Program& program, const VertexFormat& format, What what)
    {
        for (int i = 1; program.attributes_read >> i != 0; ++i) {
            if ((program.attributes_read & (1u << i)) && format.components[i] == 0) {
                what(i);
            }
        }
    }

    /// Draws what waits; everything that looks at the picture or changes what is used does so first.
    void draw_waiting()
    {
        if (batch_.empty()) {
            return;
        }
        if (waiting_page_ == STREAM) {
            geometries_.bind_stream(waiting_format_, stream_.vertices(), stream_.slots(), stream_.indices());
        } else {
            geometries_.bind_page(waiting_page_);
        }
        programs_.upload(waiting_program_, UniformGroup::transform, batch_.transforms());
        geometries_.draw_runs(batch_.runs());
        batch_.begin(1);
    }

    bool has_constants(const DrawState& state, const VertexFormat& format) const
    {
        bool all = true;
        for_each_constant(programs_[state.program], format,
                          [&](int i) { all = all && constants_[i] == (*state.constants)[i]; });
        return all;
    }

    void apply_constants(const DrawState& state, const VertexFormat& format)
    {
        for_each_constant(programs_[state.program], format, [&](int i) {
            const glm::vec4& value = (*state.constants)[i];
            if (constants_[i] == value) {
                return;
            }
            gl_.VertexAttrib4f(i, value.x, value.y, value.z, value.w);
            constants_[i] = value;
        });
    }

    bool apply(const DrawState& state, const VertexFormat& format)
    {
        if (lost_ || state.program == 0) {
            return false;
        }
        const bool usable = programs_.use(state.program);
        for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i) {
            if (const auto group = static_cast<UniformGroup>(i); group != UniformGroup::transform) {
                programs_.upload(state.program, group, state.uniforms[i]);
            }
        }
        for (int unit = SAMPLER_COUNT; unit-- > 0;) {
            if (state.textures[unit] != 0) {
                textures_.bind(state.textures[unit], unit);
            }
        }
        fixed_.apply(state.pipeline);
        apply_constants(state, format);
        return usable;
    }

    const Es3Functions gl_;
    Es3FullscreenPass fullscreen_pass_{gl_};
    Es3Target target_;
    Es3DepthReader depth_reader_{gl_, fullscreen_pass_};
    Es3FixedState fixed_{gl_, target_};
    Es3Programs programs_{gl_, counters};
    Es3Textures textures_{gl_, counters};
    Es3Geometries geometries_{gl_, counters};
    Es3Batch batch_; ///< What waits to be drawn: of a page of geometries_, or of stream_.
    Es3Stream stream_;
    std::uint32_t waiting_page_ = STREAM;
    VertexFormat waiting_format_;
    ProgramId waiting_program_ = 0;
    std::uint64_t waiting_revision_ = 0;
    std::uint64_t batch_number_ = 0;

    bool lost_ = false;
    std::optional<bool> clips_lines_; ///< Once it was asked for.
    std::array<std::optional<glm::vec4>, ATTRIBUTE_COUNT> constants_;
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
