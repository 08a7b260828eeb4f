#pragma once

#include "legacygl/vertex/format.h"

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// Vertices of one format that wait to be uploaded as one, since they are drawn once: an upload costs a
/// browser more than a draw, and immediate mode would make one a glBegin.
class Es3Stream
{
public:
    /// Starts over; nothing waits.
    void begin(const VertexFormat& format);
    /// Whether enough waits, so that the graphics processor has something to do meanwhile.
    bool full() const;

    /// Where the vertices and indices added next will begin.
    std::uint32_t first_vertex() const { return static_cast<std::uint32_t>(vertices_.size()) / floats_; }
    std::uint32_t first_index() const { return static_cast<std::uint32_t>(indices_.size()); }
    /// Adds vertices that use a slot of the transforms (see Es3Batch), the same as the last ones or the next,
    /// and indices of them.
    void add(std::span<const float> vertices, std::span<const std::uint32_t> indices, int slot);

    std::span<const float> vertices() const { return vertices_; }
    std::span<const std::uint32_t> indices() const { return indices_; }
    /// Returns the slot of each vertex; nothing when all use slot 0. Valid until the next call.
    std::span<const float> slots();

private:
    std::uint32_t floats_ = 1;
    std::vector<float> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<std::uint32_t> first_of_slot_; ///< The first vertex of each slot.
    std::vector<float> slots_;
};

} // namespace legacygl
