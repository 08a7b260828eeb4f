#pragma once

#include "legacygl/backend/backend.h"

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// Draws that wait to be uploaded as one: vertices of one format that are drawn once, with nothing changing
/// between them but the transform.
///
/// An upload costs a browser more than a draw, and immediate mode would make one a glBegin.
struct Es3Stream
{
    struct Draw
    {
        std::uint32_t first_vertex, first_index; ///< Where those of the draw begin.
        std::uint32_t first_run, runs;           ///< In `runs`.
        std::uint32_t first_value, values;       ///< Of the transform, in `transforms`.
        std::uint64_t revision;                  ///< Of the transform.
    };

    /// More floats than this are not gathered, so that the graphics processor has something to do meanwhile.
    static constexpr std::size_t ENOUGH_FLOATS = std::size_t{1} << 18;

    VertexFormat format;
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<DrawRun> runs;
    std::vector<glm::vec4> transforms;
    std::vector<Draw> draws;

    bool empty() const { return draws.empty(); }
    bool full() const { return vertices.size() > ENOUGH_FLOATS; }
    void add(const UniformValues& transform, std::span<const float> more_vertices,
             std::span<const std::uint32_t> more_indices, std::span<const DrawRun> more_runs);
    void clear();
};

} // namespace legacygl
