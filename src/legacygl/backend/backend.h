#pragma once

#include "legacygl/backend/stencil_and_blend.h"
#include "legacygl/vertex/format.h"
#include "legacygl/vertex/primitives.h"

#include <legacygl/legacygl.h>

#include <GL/gl.h>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace legacygl {

/// Names of a backend's objects; 0 is none.
using GeometryId = std::uint32_t;
using ProgramId = std::uint32_t;
using TextureId = std::uint32_t;

/// The uniform arrays of vec4 that a program may have, each uploaded as one piece when it changed.
enum class UniformGroup : std::uint8_t
{
    transform,
    lighting,
    texturing,
    fragments,
    count
};
constexpr int UNIFORM_GROUP_COUNT = static_cast<int>(UniformGroup::count);
constexpr std::array<const char*, UNIFORM_GROUP_COUNT> UNIFORM_GROUP_NAMES = {"transform", "lighting",
                                                                              "texturing", "fragments"};

/// The location of the attribute that says which slot of the uniform array `transform` a vertex uses. Where
/// no array gives it, it is 0.
constexpr int TRANSFORM_SLOT_LOCATION = ATTRIBUTE_COUNT;

/// Samplers of a program: of the texture units, then of the copy of the target that a logic op reads.
constexpr int TARGET_COPY_SAMPLER = TEXTURE_UNIT_COUNT, SAMPLER_COUNT = TEXTURE_UNIT_COUNT + 1;

/// GLSL ES 3.00 text of a program. Attributes are at the locations of Attribute, samplers are named
/// texture_0 … texture_2, uniform arrays as in UNIFORM_GROUP_NAMES.
struct ProgramText
{
    std::string vertex;
    std::string fragment;
    int transform_slots = 1;           ///< How many transforms the uniform array `transform` holds.
    std::uint32_t attributes_read = 0; ///< Bits of Attribute.
};

/// The values of one uniform group. revision is new whenever a value is.
struct UniformValues
{
    std::span<const glm::vec4> values;
    std::uint64_t revision = 0;
};

/// The fixed state of the ES pipeline that a draw wants; names as in OpenGL 1.5, table 6.x.
struct Pipeline
{
    std::array<GLint, 4> viewport{};
    std::array<GLfloat, 2> depth_range{0, 1};
    bool depth_test = false;
    bool depth_mask = true;
    GLenum depth_func = GL_LESS;
    bool cull_face = false;
    GLenum cull_face_mode = GL_BACK;
    GLenum front_face = GL_CCW;
    bool scissor_test = false;
    std::array<GLint, 4> scissor_box{};
    StencilState stencil;
    BlendState blend;
    bool polygon_offset = false;
    std::array<GLfloat, 2> polygon_offset_factor_units{0, 0};
    std::array<bool, 4> color_mask{true, true, true, true};
    bool draws_front = false; ///< Into the front colours.
    bool draws_back = true;   ///< Into the back colours; where there is one buffer, both mean it.
    bool dither = true;
    GLfloat line_width = 1;
    bool operator==(const Pipeline&) const = default;
};

/// Everything a draw needs besides its vertices.
struct DrawState
{
    ProgramId program = 0;
    std::array<UniformValues, UNIFORM_GROUP_COUNT> uniforms;
    std::array<TextureId, SAMPLER_COUNT> textures{};
    Pipeline pipeline;
    /// New whenever anything above but the transform is.
    std::uint64_t revision = 0;
    /// What an attribute is for all vertices when the format lacks it.
    const CurrentAttributes* constants = nullptr;
};

struct Clear
{
    GLbitfield buffers = 0; ///< GL_COLOR_BUFFER_BIT …
    glm::vec4 color{0, 0, 0, 0};
    GLfloat depth = 1;
    GLint stencil = 0;
};

/// How a texture is sampled (OpenGL 1.5, table 6.16).
struct Sampling
{
    GLenum minify = GL_NEAREST_MIPMAP_LINEAR;
    GLenum magnify = GL_LINEAR;
    GLenum wrap_s = GL_REPEAT;
    GLenum wrap_t = GL_REPEAT;
    GLint base_level = 0;
    GLint max_level = 1000;
    GLfloat min_lod = -1000;
    GLfloat max_lod = 1000;
    /// Whether one level is filtered linearly, however large or small it appears.
    bool is_linear() const { return minify == GL_LINEAR && magnify == GL_LINEAR; }
    bool operator==(const Sampling&) const = default;
};

/// What legacygl needs of the graphics below: one small interface, so that tests can record it.
///
/// Objects made before context_lost() are gone afterwards; their makers make them again.
class Backend
{
public:
    virtual ~Backend() = default;

    virtual ProgramId create_program(const ProgramText& text) = 0;
    virtual GeometryId create_geometry(const VertexFormat& format, std::span<const float> vertices,
                                       std::span<const std::uint32_t> indices) = 0;
    virtual void destroy_geometry(GeometryId id) = 0;
    virtual TextureId create_texture() = 0;
    virtual void destroy_texture(TextureId id) = 0;
    /// Replaces one mipmap level by width × height RGBA pixels of a byte a channel, the bottom row first.
    virtual void texture_image(TextureId id, int level, int width, int height,
                               std::span<const std::uint8_t> rgba) = 0;
    virtual void generate_mipmap(TextureId id) = 0;
    virtual void sampling(TextureId id, const Sampling& sampling) = 0;

    /// Draws a geometry. Returns false, and draws nothing, where it is better drawn as a stream now, because
    /// it is small and just was drawn with another transform.
    virtual bool draw(const DrawState& state, GeometryId geometry, std::span<const DrawRun> runs) = 0;
    /// Draws vertices that are used once.
    virtual void draw_stream(const DrawState& state, const VertexFormat& format,
                             std::span<const float> vertices, std::span<const std::uint32_t> indices,
                             std::span<const DrawRun> runs) = 0;
    /// Clears within the pipeline's masks.
    virtual void clear(const Pipeline& pipeline, const Clear& clear) = 0;
    /// Reads width × height RGBA pixels of a byte a channel from the front or back, the bottom row first.
    virtual void read_pixels(bool front, int x, int y, int width, int height,
                             std::span<std::uint8_t> rgba) = 0;
    /// Reads the depths of width × height pixels in steps of 1 / (2^24 - 1), the bottom row first. Returns
    /// false when they cannot be read.
    virtual bool read_depths(int x, int y, int width, int height, std::span<std::uint32_t> depths) = 0;
    /// Reads stencil values the same way.
    virtual bool read_stencils(int x, int y, int width, int height, std::span<std::uint8_t> values) = 0;
    /// Returns whether lines are cut at the sides of the view volume as OpenGL says, however far outside they
    /// end. Where not, they have to end inside.
    virtual bool clips_lines() = 0;
    virtual void flush(bool wait) = 0;

    /// Follows target_width and target_height, which have changed.
    virtual void resize(int width, int height) = 0;
    /// Copies the back into the front and shows the front.
    virtual void present() = 0;
    virtual void show_front() = 0;
    virtual void context_lost() = 0;
    virtual void context_restored() = 0;

    int maximum_texture_size = 2048;   ///< In texels, both ways; the least that WebGL 2 allows.
    int maximum_viewport_size = 16384; ///< In pixels, both ways.
    int target_width = 0;              ///< Of what is drawn into, in pixels.
    int target_height = 0;
    LegacyGLCounters counters{};
    /// The widest line that can be drawn; wider ones must come as triangles.
    float maximum_line_width = 1;
    /// Counts the ES contexts lost so far; an object made in another generation is gone.
    std::uint32_t generation = 0;
};

/// One object of a backend: freed with its owner, forgotten when its context was lost.
template <class Id, void (Backend::*destroy)(Id)> class BackendObject
{
public:
    BackendObject() = default;
    BackendObject(BackendObject&& other) noexcept
        : backend_(other.backend_), id_(std::exchange(other.id_, 0)), generation_(other.generation_)
    {}
    BackendObject& operator=(BackendObject&& other) noexcept
    {
        std::swap(backend_, other.backend_);
        std::swap(id_, other.id_);
        std::swap(generation_, other.generation_);
        return *this;
    }
    ~BackendObject() { reset(); }

    /// Whether the object is there; if not, its maker makes it again.
    bool valid() const { return id_ != 0 && backend_->generation == generation_; }
    Id id() const { return id_; }
    void set(Backend& backend, Id id)
    {
        reset();
        backend_ = &backend;
        id_ = id;
        generation_ = backend.generation;
    }
    void reset()
    {
        if (valid()) {
            (backend_->*destroy)(id_);
        }
        id_ = 0;
    }

private:
    Backend* backend_ = nullptr;
    Id id_ = 0;
    std::uint32_t generation_ = 0;
};

using GeometryObject = BackendObject<GeometryId, &Backend::destroy_geometry>;
using TextureObject = BackendObject<TextureId, &Backend::destroy_texture>;

} // namespace legacygl
