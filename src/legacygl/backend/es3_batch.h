#pragma once

#include "legacygl/backend/backend.h"

#include <cstdint>
#include <span>
#include <vector>

namespace legacygl {

/// Draws of one vertex array that wait to be drawn as one, with nothing changing between them but the
/// transform.
///
/// A draw costs a browser more than the few vertices of a glBegin or of a small list. Draws with different
/// transforms follow each other in one call, since each vertex says which slot of the program's transforms is
/// its own (see TRANSFORM_SLOT_LOCATION).
class Es3Batch
{
public:
    /// Starts over for a program with so many slots; nothing waits.
    void begin(int slots);
    bool empty() const { return runs_.empty(); }

    /// Gives the next draw's transform a slot of its choice. Returns false when there is none left.
    bool put(const UniformValues& transform);
    /// Gives it the slot asked for, counted modulo the slots there are. Returns false when it holds another.
    bool put(const UniformValues& transform, std::uint32_t slot);
    /// The slot that the last transform was given.
    int slot() const { return slot_; }
    /// Adds what is drawn with that transform; indices and vertices begin at these places of the array.
    void add(std::span<const DrawRun> runs, std::uint32_t first_vertex, std::uint32_t first_index);

    std::span<const DrawRun> runs() const { return runs_; }
    /// The transforms from slot 0 to the last one in use. Their revision is slot 0's if no other is in use,
    /// or 0.
    UniformValues transforms() const;

private:
    void add(DrawRun run);

    std::size_t transform_size_ = 0;
    int slot_ = -1;
    int used_slots_ = 0;                   ///< The greatest slot in use, and one.
    std::vector<std::uint64_t> revisions_; ///< By slot; 0: it is free.
    std::vector<glm::vec4> transforms_;
    std::vector<DrawRun> runs_;
};

} // namespace legacygl
