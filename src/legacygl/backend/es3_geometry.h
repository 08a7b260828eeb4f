#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/backend/es3_functions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// A vertex array with buffers for vertices of one format and for indices.
struct Es3VertexArray
{
    GLuint name = 0;
    GLuint vertices = 0;
    GLuint indices = 0;
    GLuint slots = 0; ///< The slot of each vertex; 0: all use slot 0.
    VertexFormat format;
};

/// The vertices and indices of a backend: those that stay, and vertex arrays for those that are used once.
///
/// Small geometries of one format share a page: drawn in the order they were made in, they lie one behind the
/// other, each with the next slot of the transforms, and one call draws many.
class Es3Geometries
{
public:
    /// More floats than this do not share a page.
    static constexpr std::size_t SMALL_FLOATS = 2048;

    /// Where a geometry lies.
    struct Place
    {
        std::uint32_t page = 0; ///< Never 0.
        std::uint32_t first_vertex = 0;
        std::uint32_t first_index = 0;
        std::uint32_t slot = 0;  ///< That its vertices name, modulo what a program has.
        bool small = false;      ///< It shares the page.
        std::uint64_t batch = 0; ///< Of the backend: the number of the batch that it was last drawn in.
    };

    Es3Geometries(const Es3Functions& functions, LegacyGLCounters& counters)
        : gl_(functions), counters_(counters)
    {}

    GeometryId create(const VertexFormat& format, std::span<const float> vertices,
                      std::span<const std::uint32_t> indices);
    void destroy(GeometryId id);
    Place& place(GeometryId id) { return geometries_[id]; }
    const VertexFormat& format(GeometryId id) const { return pages_[geometries_[id].page].array.format; }

    /// Binds the vertex array of a page.
    void bind_page(std::uint32_t page) { bind(pages_[page].array.name); }
    /// Uploads what is drawn once and binds its vertex array. slots: of each vertex that of its transform;
    /// none: slot 0.
    void bind_stream(const VertexFormat& format, std::span<const float> vertices,
                     std::span<const float> slots, std::span<const std::uint32_t> indices);
    /// Draws runs of the bound vertex array.
    void draw_runs(std::span<const DrawRun> runs);

    /// Deletes all objects.
    void clear();
    /// Forgets all objects, which went with their context.
    void forget();
    /// Forgets what is bound, which others changed.
    void forget_binding() { bound_ = 0; }

private:
    /// Buffers that geometries of one format share, filled from the front; freed when the last of them is.
    struct Page
    {
        Es3VertexArray array;
        bool shared = false;
        std::uint32_t used_vertices = 0;
        std::uint32_t used_indices = 0;
        std::uint32_t made = 0;       ///< How many geometries it ever got.
        std::uint32_t geometries = 0; ///< 0: the page is free.
    };

    std::uint32_t page_for(const VertexFormat& format, std::size_t floats, std::size_t indices);
    std::uint32_t make_page(const VertexFormat& format, bool shared);
    void fill_own(const Page& page, std::span<const float> vertices, std::span<const std::uint32_t> indices);
    void append(Page& page, std::span<const float> vertices, std::span<const std::uint32_t> indices);
    Es3VertexArray make_array(const VertexFormat& format, bool with_slots);
    void destroy(Es3VertexArray& array);
    void bind(GLuint vertex_array);
    void allocate(GLenum target, GLuint buffer, std::size_t bytes);
    void upload(GLenum target, GLuint buffer, std::size_t bytes, const void* data, GLenum usage);
    void upload_part(GLenum target, GLuint buffer, std::size_t offset, std::size_t bytes, const void* data);
    void bind_buffer(GLenum target, GLuint buffer);

    const Es3Functions& gl_;
    LegacyGLCounters& counters_;
    std::vector<Page> pages_{1};       ///< The first stays empty, so that 0 can mean none.
    std::vector<Place> geometries_{1}; ///< The same.
    std::vector<GeometryId> free_;
    std::vector<Es3VertexArray> streams_; ///< One a format, with slots and without, made at its first use.
    std::vector<std::uint32_t> rebased_;  ///< Scratch.
    std::vector<float> slots_;            ///< Scratch.
    GLuint bound_ = 0;                    ///< 0: not known.
};

} // namespace legacygl
