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
class Es3Geometries
{
public:
    Es3Geometries(const Es3Functions& functions, LegacyGLCounters& counters)
        : gl_(functions), counters_(counters)
    {}

    GeometryId create(const VertexFormat& format, std::span<const float> vertices,
                      std::span<const std::uint32_t> indices);
    void destroy(GeometryId id);
    const VertexFormat& format(GeometryId id) const { return geometries_[id].format; }
    void draw(GeometryId id, std::span<const DrawRun> runs);

    /// Uploads what is drawn once and binds its vertex array. draw_runs then draws of it. slots: of each vertex
    /// that of its transform; none: slot 0.
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
    Es3VertexArray make_array(const VertexFormat& format, bool with_slots);
    void destroy(Es3VertexArray& array);
    void bind(GLuint vertex_array);
    void upload(GLenum target, GLuint buffer, std::size_t bytes, const void* data, GLenum usage);

    const Es3Functions& gl_;
    LegacyGLCounters& counters_;
    std::vector<Es3VertexArray> geometries_{1}; ///< The first stays empty, so that 0 can mean none.
    std::vector<GeometryId> free_;
    std::vector<Es3VertexArray> streams_; ///< One a format, with slots and without, made at its first use.
    GLuint bound_ = 0;                    ///< 0: not known.
};

} // namespace legacygl
