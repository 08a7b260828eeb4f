#include "legacygl/backend/es3_batch.h"

#include <algorithm>

namespace legacygl {

void Es3Batch::begin(int slots)
{
    runs_.clear();
    revisions_.assign(static_cast<std::size_t>(slots), 0);
    slot_ = -1;
    used_slots_ = 0;
}

bool Es3Batch::put(const UniformValues& transform)
{
    if (slot_ >= 0 && revisions_[slot_] == transform.revision) {
        return true;
    }
    return used_slots_ < static_cast<int>(revisions_.size()) &&
           put(transform, static_cast<std::uint32_t>(used_slots_));
}

bool Es3Batch::put(const UniformValues& transform, std::uint32_t slot)
{
    const auto at = static_cast<int>(slot % revisions_.size());
    if (revisions_[at] != transform.revision) {
        if (revisions_[at] != 0) {
            return false;
        }
        transform_size_ = transform.values.size();
        used_slots_ = std::max(used_slots_, at + 1);
        if (transforms_.size() < transform_size_ * used_slots_) {
            transforms_.resize(transform_size_ * revisions_.size());
        }
        revisions_[at] = transform.revision;
        std::copy(transform.values.begin(), transform.values.end(),
                  transforms_.begin() + static_cast<std::ptrdiff_t>(transform_size_) * at);
    }
    slot_ = at;
    return true;
}

void Es3Batch::add(std::span<const DrawRun> runs, std::uint32_t first_vertex, std::uint32_t first_index)
{
    for (DrawRun run : runs) {
        run.first += run.indexed ? first_index : first_vertex;
        add(run);
    }
}

/// Adds a run to what is drawn in one call if it goes on where the last one ended.
void Es3Batch::add(DrawRun run)
{
    if (!runs_.empty()) {
        DrawRun& last = runs_.back();
        if (last.primitive == run.primitive && last.indexed == run.indexed &&
            last.first + last.count == run.first) {
            last.count += run.count;
            return;
        }
    }
    runs_.push_back(run);
}

UniformValues Es3Batch::transforms() const
{
    return {std::span(transforms_).first(transform_size_ * used_slots_),
            used_slots_ == 1 ? revisions_[0] : 0};
}

} // namespace legacygl
