#include "legacygl/backend/es3_stream.h"

namespace legacygl {
namespace {

template <class T> std::uint32_t append(std::vector<T>& to, std::span<const T> more)
{
    const auto first = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), more.begin(), more.end());
    return first;
}

} // namespace

void Es3Stream::add(const UniformValues& transform, std::span<const float> more_vertices,
                    std::span<const std::uint32_t> more_indices, std::span<const DrawRun> more_runs)
{
    Draw draw{};
    draw.first_vertex = append(vertices, more_vertices) / static_cast<std::uint32_t>(format.floats());
    draw.first_index = append(indices, more_indices);
    for (std::size_t i = draw.first_index; i < indices.size(); ++i)
        indices[i] += draw.first_vertex;
    draw.first_run = append(runs, more_runs);
    draw.runs = static_cast<std::uint32_t>(more_runs.size());
    draw.revision = transform.revision;
    draw.first_value = append(transforms, transform.values);
    draw.values = static_cast<std::uint32_t>(transform.values.size());
    draws.push_back(draw);
}

void Es3Stream::clear()
{
    vertices.clear();
    indices.clear();
    runs.clear();
    transforms.clear();
    draws.clear();
}

} // namespace legacygl
