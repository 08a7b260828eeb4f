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
    VertexFormat format;
};

/// The vertices and indices of a backend: those that stay, and vertex arrays for those that are used once.
///
/// Small geometries of one format share buffers, so that lists that are drawn one after the other need no
/// other vertex array.
class Es3Geometries
{
public:
    Es3Geometries(const Es3Functions& functions, LegacyGLCounters& counters)
        : gl_(functions), counters_(counters)
    {}

    GeometryId create(const VertexFormat& format, std::span<const float> vertices,
                      std::span<const std::uint32_t> indices);
    void destroy(GeometryId id);
    const VertexFormat& format(GeometryId id) const { return pages_[geometries_[id].page].array.format; }
    void draw(GeometryId id, std::span<const DrawRun> runs);

    /// Uploads what is drawn once and binds its vertex array. draw_runs then draws of it.
    void bind_stream(const VertexFormat& format, std::span<const float> vertices,
                     std::span<const std::uint32_t> indices);
    /// Draws runs of the bound vertex array, whose vertices and indices begin at these places.
    void draw_runs(std::span<const DrawRun> runs, std::uint32_t first_vertex, std::uint32_t first_index);

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
        std::uint32_t used_floats = 0;
        std::uint32_t used_indices = 0;
        std::uint32_t geometries = 0; ///< 0: the page is free.
    };
    struct Geometry
    {
        std::uint32_t page = 0;
        std::uint32_t first_vertex = 0;
        std::uint32_t first_index = 0;
    };

    std::uint32_t page_for(const VertexFormat& format, std::size_t floats, std::size_t indices);
    std::uint32_t make_page(const VertexFormat& format);
    Es3VertexArray make_array(const VertexFormat& format);
    void destroy(Es3VertexArray& array);
    void bind(GLuint vertex_array);
    void allocate(GLenum target, std::size_t bytes, const void* data, GLenum usage);
    void upload(GLenum target, std::size_t offset, std::size_t bytes, const void* data);
    void count_upload(std::size_t bytes);

    const Es3Functions& gl_;
    LegacyGLCounters& counters_;
    std::vector<Page> pages_;
    std::vector<Geometry> geometries_{1}; ///< The first stays empty, so that 0 can mean none.
    std::vector<GeometryId> free_;
    std::vector<Es3VertexArray> streams_; ///< One a format, made at its first use.
    std::vector<std::uint32_t> rebased_;  ///< Scratch.
    GLuint bound_ = 0;                    ///< 0: not known.
};

} // namespace legacygl
