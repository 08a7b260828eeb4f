#pragma once

#include "legacygl/backend/backend.h"

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// Draws that wait to be drawn as one: vertices of one format that are uploaded for this alone, with nothing
/// changing between them but the transform.
///
/// An upload or a draw costs a browser more than the few vertices of a glBegin or of a small list, so that
/// those with other transforms follow each other in one draw call, too: each vertex says which slot of the
/// program's transforms is its own (see TRANSFORM_SLOT_LOCATION).
class Es3Stream
{
public:
    /// Begins anew for a program with so many slots; nothing waits.
    void begin(const VertexFormat& format, int slots);
    /// Adds a draw. Returns false, and adds nothing, when there is no slot left for its transform or enough
    /// has been gathered, so that the graphics processor has something to do meanwhile.
    bool add(const UniformValues& transform, std::span<const float> more_vertices,
             std::span<const std::uint32_t> more_indices, std::span<const DrawRun> more_runs);
    void clear();

    bool empty() const { return runs_.empty(); }
    const VertexFormat& format() const { return format_; }
    std::span<const float> vertices() const { return vertices_; }
    std::span<const std::uint32_t> indices() const { return indices_; }
    std::span<const DrawRun> runs() const { return runs_; }
    /// The transforms of all slots in use, one behind the other.
    std::span<const glm::vec4> transforms() const { return transforms_; }
    bool uses_slots() const { return slots_.size() > 1; }
    /// The revision of slot 0's transform.
    std::uint64_t first_revision() const { return slots_.front().revision; }
    /// Returns the slot of each vertex; nothing when there is but one. Valid until the next call.
    std::span<const float> slot_of_vertices();

private:
    struct Slot
    {
        std::uint32_t first_vertex; ///< The first vertex that uses it.
        std::uint64_t revision;
    };

    void add_run(DrawRun run, std::uint32_t first_vertex, std::uint32_t first_index);

    VertexFormat format_;
    std::uint32_t floats_ = 0;
    std::size_t slot_count_ = 1;
    std::vector<float> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<DrawRun> runs_;
    std::vector<glm::vec4> transforms_;
    std::vector<Slot> slots_;
    std::vector<float> slot_of_vertices_;
};

} // namespace legacygl
