#include "legacygl/backend/es3_stream.h"

#include <algorithm>

namespace legacygl {

void Es3Stream::begin(const VertexFormat& format)
{
    floats_ = static_cast<std::uint32_t>(format.floats());
    vertices_.clear();
    indices_.clear();
    first_of_slot_.clear();
}

bool Es3Stream::full() const
{
    constexpr std::size_t ENOUGH_FLOATS = std::size_t{1} << 15;
    return vertices_.size() > ENOUGH_FLOATS;
}

void Es3Stream::add(std::span<const float> vertices, std::span<const std::uint32_t> indices, int slot)
{
    const std::uint32_t first = first_vertex();
    if (slot == static_cast<int>(first_of_slot_.size())) {
        first_of_slot_.push_back(first);
    }
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    for (const std::uint32_t index : indices) {
        indices_.push_back(first + index);
    }
}

std::span<const float> Es3Stream::slots()
{
    if (first_of_slot_.size() <= 1) {
        return {};
    }
    slots_.resize(first_vertex());
    for (std::size_t slot = 0; slot < first_of_slot_.size(); ++slot) {
        const bool last = slot + 1 == first_of_slot_.size();
        std::fill(slots_.begin() + first_of_slot_[slot],
                  last ? slots_.end() : slots_.begin() + first_of_slot_[slot + 1], static_cast<float>(slot));
    }
    return slots_;
}

} // namespace legacygl
