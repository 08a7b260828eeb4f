#include "legacygl/backend/es3_stream.h"

#include <algorithm>

namespace legacygl {
namespace {

constexpr std::size_t ENOUGH_FLOATS = std::size_t{1} << 15;

template <class T> std::uint32_t append(std::vector<T>& to, std::span<const T> more)
{
    const auto first = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), more.begin(), more.end());
    return first;
}

} // namespace

void Es3Stream::begin(const VertexFormat& format, int slots)
{
    clear();
    format_ = format;
    floats_ = static_cast<std::uint32_t>(format.floats());
    slot_count_ = static_cast<std::size_t>(slots);
}

bool Es3Stream::add(const UniformValues& transform, std::span<const float> more_vertices,
                    std::span<const std::uint32_t> more_indices, std::span<const DrawRun> more_runs)
{
    const bool same_transform = !slots_.empty() && slots_.back().revision == transform.revision;
    if (vertices_.size() > ENOUGH_FLOATS || (!same_transform && slots_.size() == slot_count_))
        return false;
    const std::uint32_t first_vertex = append(vertices_, more_vertices) / floats_;
    const std::uint32_t first_index = append(indices_, more_indices);
    for (std::size_t i = first_index; i < indices_.size(); ++i)
        indices_[i] += first_vertex;
    for (const DrawRun& run : more_runs)
        add_run(run, first_vertex, first_index);
    if (!same_transform) {
        slots_.push_back({first_vertex, transform.revision});
        append(transforms_, transform.values);
    }
    return true;
}

/// Adds a run to what is drawn in one call if it goes on where the last one ended.
void Es3Stream::add_run(DrawRun run, std::uint32_t first_vertex, std::uint32_t first_index)
{
    run.first += run.indexed ? first_index : first_vertex;
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

std::span<const float> Es3Stream::slot_of_vertices()
{
    if (!uses_slots())
        return {};
    slot_of_vertices_.resize(vertices_.size() / floats_);
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
        const auto begin = slot_of_vertices_.begin() + slots_[slot].first_vertex;
        const auto end = slot + 1 == slots_.size() ? slot_of_vertices_.end()
                                                   : slot_of_vertices_.begin() + slots_[slot + 1].first_vertex;
        std::fill(begin, end, static_cast<float>(slot));
    }
    return slot_of_vertices_;
}

void Es3Stream::clear()
{
    vertices_.clear();
    indices_.clear();
    runs_.clear();
    transforms_.clear();
    slots_.clear();
}

} // namespace legacygl
